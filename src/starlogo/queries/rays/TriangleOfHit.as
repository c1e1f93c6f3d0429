package starlogo.queries.rays
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.copyVector;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.building.TriangleLabels;
    import starlogo.queries.CastHit;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Writes what a hit tells of the triangle that is met: its mesh, its material, and where on it the point is.
     *
     * @private
     */
    public final class TriangleOfHit
    {
        // From the point to each corner.
        private var _a:Vector3D = new Vector3D();
        private var _b:Vector3D = new Vector3D();
        private var _c:Vector3D = new Vector3D();

        // The weights of the corners.
        private var _weights:Vector3D = new Vector3D();

        /**
         * Writes the mesh, the material and the weights.
         *
         * @param body the body that is met
         * @param hit has the number of the triangle and the point
         */
        public function write(body:Body, hit:CastHit):void
        {
            hit.mesh = hit.material = -1;
            hit.meshName = hit.materialName = null;
            _weights.setTo(0, 0, 0);
            if (hit.triangle >= 0)
            {
                if (body.shape.model != null)
                {
                    var meshes:TriangleLabels = body.shape.model.data.meshes;
                    var materials:TriangleLabels = body.shape.model.data.materials;
                    hit.mesh = meshes.labelOf(hit.triangle);
                    hit.meshName = meshes.nameOf(hit.mesh);
                    hit.material = materials.labelOf(hit.triangle);
                    hit.materialName = materials.nameOf(hit.material);
                }
                readCorners(body.shape.tree.boxTree, 3 * hit.triangle, body.placement, hit.point);
                weigh(_weights);
            }
            copyVector(_weights, hit.weights);
        }

        private function readCorners(tree:BoxTree, corner:int, placement:Placement, point:Vector3D):void
        {
            var x:Number = (point.x - placement.x) / placement.size;
            var y:Number = (point.y - placement.y) / placement.size;
            var z:Number = (point.z - placement.z) / placement.size;
            var inX:Number = placement.r00 * x + placement.r10 * y + placement.r20 * z;
            var inY:Number = placement.r01 * x + placement.r11 * y + placement.r21 * z;
            var inZ:Number = placement.r02 * x + placement.r12 * y + placement.r22 * z;
            readCorner(tree, corner, inX, inY, inZ, _a);
            readCorner(tree, corner + 1, inX, inY, inZ, _b);
            readCorner(tree, corner + 2, inX, inY, inZ, _c);
        }

        // The way to a corner from a point in the model's space.
        private static function readCorner(tree:BoxTree, corner:int, x:Number, y:Number, z:Number, out:Vector3D):void
        {
            var vertex:int = 3 * tree.triangles[corner];
            out.setTo(tree.vertices[vertex] - x, tree.vertices[int(vertex + 1)] - y, tree.vertices[int(vertex + 2)] - z);
        }

        // Weighs the corners from the longest edge, because along it even a narrow triangle has digits.
        private function weigh(weights:Vector3D):void
        {
            var ab:Number = squaredDistance(_a, _b);
            var bc:Number = squaredDistance(_b, _c);
            var ca:Number = squaredDistance(_c, _a);
            if (ab >= bc && ab >= ca)
            {
                weighFrom(_a, _b, _c, ab, weights);
            }
            else if (bc >= ca)
            {
                weighFrom(_b, _c, _a, bc, weights);
                weights.setTo(weights.z, weights.x, weights.y);
            }
            else
            {
                weighFrom(_c, _a, _b, ca, weights);
                weights.setTo(weights.y, weights.z, weights.x);
            }
        }

        private static function squaredDistance(u:Vector3D, v:Vector3D):Number
        {
            var x:Number = v.x - u.x;
            var y:Number = v.y - u.y;
            var z:Number = v.z - u.z;
            return x * x + y * y + z * z;
        }

        // Finds the weights of an edge's ends, x and y, and of the corner over it, z. The point's height over the edge, as a part of the corner's, is the
        // weight of the corner. Its place along the edge divides the rest. What is beyond an edge of the triangle counts as on it.
        private static function weighFrom(start:Vector3D, end:Vector3D, over:Vector3D, squaredLength:Number, weights:Vector3D):void
        {
            var edgeX:Number = end.x - start.x;
            var edgeY:Number = end.y - start.y;
            var edgeZ:Number = end.z - start.z;
            var x:Number = over.x - start.x;
            var y:Number = over.y - start.y;
            var z:Number = over.z - start.z;
            // the places along the edge of the point and of the corner
            var along:Number = 0;
            var alongOver:Number = 0;
            if (squaredLength > 0)
            {
                along = Math.max(0, Math.min(1, -(start.x * edgeX + start.y * edgeY + start.z * edgeZ) / squaredLength));
                alongOver = (x * edgeX + y * edgeY + z * edgeZ) / squaredLength;
            }
            x -= alongOver * edgeX;
            y -= alongOver * edgeY;
            z -= alongOver * edgeZ;
            var height:Number = -(x * (start.x + along * edgeX) + y * (start.y + along * edgeY) + z * (start.z + along * edgeZ));
            var squaredHeight:Number = x * x + y * y + z * z;
            var weight:Number = squaredHeight > 0 ? Math.max(0, height / squaredHeight) : 0;
            // the triangle's height there, as a part of the corner's, is room / side
            var room:Number = along < alongOver ? along : 1 - along;
            var side:Number = along < alongOver ? alongOver : 1 - alongOver;
            weight = weight * side > room ? room / side : Math.min(1, weight);
            weights.z = weight;
            weights.y = Math.max(0, Math.min(1 - weight, along - weight * alongOver));
            weights.x = 1 - weight - weights.y;
        }
    }
}

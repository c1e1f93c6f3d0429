package starlogo.queries.rays
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.TriangleLabels;
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
        // From the point to each corner, and the triangle's normal.
        private var _a:Vector3D = new Vector3D();
        private var _b:Vector3D = new Vector3D();
        private var _c:Vector3D = new Vector3D();
        private var _normal:Vector3D = new Vector3D();

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
            hit.weights.setTo(0, 0, 0);
            if (hit.triangle < 0)
            {
                return;
            }
            if (body.shape.model != null)
            {
                var meshes:TriangleLabels = body.shape.model.data.meshes;
                var materials:TriangleLabels = body.shape.model.data.materials;
                hit.mesh = meshes.numberOf(hit.triangle);
                hit.meshName = meshes.nameOf(hit.mesh);
                hit.material = materials.numberOf(hit.triangle);
                hit.materialName = materials.nameOf(hit.material);
            }
            readCorners(body.shape.hierarchy.boxTree, 3 * hit.triangle, body.placement, hit.point);
            weigh(hit.weights);
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

        // Each weight is the share of the part between the point and the other two corners. A part beyond an edge counts as 0. If the triangle has
        // no area, the nearest corner has all the weight.
        private function weigh(weights:Vector3D):void
        {
            _normal.setTo(0, 0, 0);
            addCross(_b, _c, _normal);
            addCross(_c, _a, _normal);
            addCross(_a, _b, _normal);
            weights.setTo(areaBetween(_b, _c), areaBetween(_c, _a), areaBetween(_a, _b));
            var sum:Number = weights.x + weights.y + weights.z;
            if (sum > 0)
            {
                weights.setTo(weights.x / sum, weights.y / sum, weights.z / sum);
                return;
            }
            var a:Number = _a.lengthSquared;
            var b:Number = _b.lengthSquared;
            var c:Number = _c.lengthSquared;
            var nearest:int = a <= b && a <= c ? 0 : (b <= c ? 1 : 2);
            weights.setTo(nearest == 0 ? 1 : 0, nearest == 1 ? 1 : 0, nearest == 2 ? 1 : 0);
        }

        // The area between the point and two corners, in a unit of its own; 0 if it is beyond the edge.
        private function areaBetween(u:Vector3D, v:Vector3D):Number
        {
            return Math.max(0, _normal.x * (u.y * v.z - u.z * v.y) + _normal.y * (u.z * v.x - u.x * v.z) + _normal.z * (u.x * v.y - u.y * v.x));
        }

        private static function addCross(u:Vector3D, v:Vector3D, sum:Vector3D):void
        {
            sum.x += u.y * v.z - u.z * v.y;
            sum.y += u.z * v.x - u.x * v.z;
            sum.z += u.x * v.y - u.y * v.x;
        }
    }
}

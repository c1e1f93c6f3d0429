package starlogo.queries.rays
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.building.TriangleLabels;
    import starlogo.queries.CastHit;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Writes what a ray or a cast tells of a row that it meets: the agent, the point and the normal, and the triangle there, with its mesh, its
     * material, and where on it the point is.
     *
     * @private
     */
    public final class HitWriter
    {
        private var _seen:SeenAgents;

        // From the point to each corner, and the weights of the corners.
        private var _corners:Vector.<Vector3D> = new <Vector3D>[new Vector3D(), new Vector3D(), new Vector3D()];
        private var _weights:Vector.<Number> = new Vector.<Number>(3, true);

        /** @param seen has the rows */
        public function HitWriter(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Writes a hit, all but its distance or time.
         *
         * @param row the row that is met
         * @param contact where it is met
         */
        public function write(row:int, contact:ContactPoint, hit:CastHit):void
        {
            hit.agent = _seen.table.list.agentsByRow[row];
            // not setTo, because a game in JavaScript may have given a hit any objects with x, y and z
            hit.point.x = contact.x;
            hit.point.y = contact.y;
            hit.point.z = contact.z;
            hit.normal.x = contact.normalX;
            hit.normal.y = contact.normalY;
            hit.normal.z = contact.normalZ;
            hit.triangle = contact.triangle;
            writeTriangle(_seen.table.bodyOf(row), hit);
        }

        private function writeTriangle(body:Body, hit:CastHit):void
        {
            hit.mesh = hit.material = -1;
            hit.meshName = hit.materialName = null;
            _weights[0] = _weights[1] = _weights[2] = 0;
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
                weigh();
            }
            hit.weights.x = _weights[0];
            hit.weights.y = _weights[1];
            hit.weights.z = _weights[2];
        }

        private function readCorners(tree:BoxTree, corner:int, placement:Placement, point:Vector3D):void
        {
            var x:Number = (point.x - placement.x) / placement.size;
            var y:Number = (point.y - placement.y) / placement.size;
            var z:Number = (point.z - placement.z) / placement.size;
            var inX:Number = placement.r00 * x + placement.r10 * y + placement.r20 * z;
            var inY:Number = placement.r01 * x + placement.r11 * y + placement.r21 * z;
            var inZ:Number = placement.r02 * x + placement.r12 * y + placement.r22 * z;
            for (var i:int = 0; i < 3; i++)
            {
                var vertex:int = 3 * tree.triangles[corner + i];
                _corners[i].setTo(tree.vertices[vertex] - inX, tree.vertices[int(vertex + 1)] - inY, tree.vertices[int(vertex + 2)] - inZ);
            }
        }

        // Weighs the corners from the longest edge, because along it even a narrow triangle has digits.
        private function weigh():void
        {
            var start:int = 0;
            var longest:Number = -1;
            for (var i:int = 0; i < 3; i++)
            {
                var square:Number = squaredDistance(_corners[i], _corners[(i + 1) % 3]);
                if (square > longest)
                {
                    longest = square;
                    start = i;
                }
            }
            weighFrom(start, (start + 1) % 3, (start + 2) % 3, longest);
        }

        private static function squaredDistance(u:Vector3D, v:Vector3D):Number
        {
            var x:Number = v.x - u.x;
            var y:Number = v.y - u.y;
            var z:Number = v.z - u.z;
            return x * x + y * y + z * z;
        }

        // Finds the weights of an edge's ends and of the corner over it. The point's height over the edge, as a part of the corner's, is the
        // weight of the corner. Its place along the edge divides the rest. What is beyond an edge of the triangle counts as on it.
        private function weighFrom(first:int, second:int, third:int, squaredLength:Number):void
        {
            var start:Vector3D = _corners[first];
            var end:Vector3D = _corners[second];
            var over:Vector3D = _corners[third];
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
            var weightOfEnd:Number = Math.max(0, Math.min(1 - weight, along - weight * alongOver));
            _weights[third] = weight;
            _weights[second] = weightOfEnd;
            _weights[first] = 1 - weight - weightOfEnd;
        }
    }
}

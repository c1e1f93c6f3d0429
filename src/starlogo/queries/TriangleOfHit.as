package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.TriangleLabels;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Says what a hit tells of the triangle that is met: its mesh, its material, and where on it the point is.
     *
     * @private
     */
    public final class TriangleOfHit
    {
        /** The number of the mesh, or -1. */
        public var mesh:int = -1;

        /** The number of the material, or -1. */
        public var material:int = -1;

        /** The name of the material, or null. */
        public var materialName:String = null;

        // From the point to each corner, in the model's space.
        private var _a:Vector3D = new Vector3D();
        private var _b:Vector3D = new Vector3D();
        private var _c:Vector3D = new Vector3D();

        // Vectors across the parts between the point and two corners, as long as twice their areas; and their sum. Before it is known, the last has
        // the point.
        private var _acrossA:Vector3D = new Vector3D();
        private var _acrossB:Vector3D = new Vector3D();
        private var _acrossC:Vector3D = new Vector3D();
        private var _normal:Vector3D = new Vector3D();

        /**
         * Reads a triangle.
         *
         * @param body the body that is met
         * @param triangle its number; -1 for none
         * @param point where it is met, in the world
         * @param weights receives the barycentric coordinates of the point; 0 if there is no triangle
         */
        public function read(body:Body, triangle:int, point:Vector3D, weights:Vector3D):void
        {
            mesh = material = -1;
            materialName = null;
            weights.setTo(0, 0, 0);
            if (triangle < 0)
            {
                return;
            }
            if (body.shape.source != null)
            {
                var materials:TriangleLabels = body.shape.source.data.materials;
                mesh = TriangleLabels.numberOf(body.shape.source.data.meshes, triangle);
                material = TriangleLabels.numberOf(materials, triangle);
                materialName = TriangleLabels.nameOf(materials, material);
            }
            readCorners(body.shape.hierarchy.tree, 3 * triangle, body.placement, point);
            weigh(weights);
        }

        private function readCorners(tree:BoxTree, corner:int, placement:Placement, point:Vector3D):void
        {
            var x:Number = (point.x - placement.x) / placement.size;
            var y:Number = (point.y - placement.y) / placement.size;
            var z:Number = (point.z - placement.z) / placement.size;
            _normal.x = placement.r00 * x + placement.r10 * y + placement.r20 * z;
            _normal.y = placement.r01 * x + placement.r11 * y + placement.r21 * z;
            _normal.z = placement.r02 * x + placement.r12 * y + placement.r22 * z;
            readCorner(tree, corner, _a);
            readCorner(tree, corner + 1, _b);
            readCorner(tree, corner + 2, _c);
        }

        private function readCorner(tree:BoxTree, corner:int, out:Vector3D):void
        {
            var vertex:int = 3 * tree.triangles[corner];
            out.x = tree.vertices[vertex] - _normal.x;
            out.y = tree.vertices[int(vertex + 1)] - _normal.y;
            out.z = tree.vertices[int(vertex + 2)] - _normal.z;
        }

        // Each weight is the share of the part between the point and the other two corners. A part beyond an edge counts as 0. If the triangle has
        // no area, the nearest corner has all the weight.
        private function weigh(weights:Vector3D):void
        {
            cross(_b, _c, _acrossA);
            cross(_c, _a, _acrossB);
            cross(_a, _b, _acrossC);
            _normal.x = _acrossA.x + _acrossB.x + _acrossC.x;
            _normal.y = _acrossA.y + _acrossB.y + _acrossC.y;
            _normal.z = _acrossA.z + _acrossB.z + _acrossC.z;
            weights.x = Math.max(0, _normal.dotProduct(_acrossA));
            weights.y = Math.max(0, _normal.dotProduct(_acrossB));
            weights.z = Math.max(0, _normal.dotProduct(_acrossC));
            var sum:Number = weights.x + weights.y + weights.z;
            if (!(sum > 0))
            {
                takeNearest(weights);
                return;
            }
            weights.x /= sum;
            weights.y /= sum;
            weights.z /= sum;
        }

        private function takeNearest(weights:Vector3D):void
        {
            var a:Number = _a.lengthSquared;
            var b:Number = _b.lengthSquared;
            var c:Number = _c.lengthSquared;
            weights.x = weights.y = weights.z = 0;
            if (a <= b && a <= c)
            {
                weights.x = 1;
            }
            else if (b <= c)
            {
                weights.y = 1;
            }
            else
            {
                weights.z = 1;
            }
        }

        private static function cross(u:Vector3D, v:Vector3D, out:Vector3D):void
        {
            out.x = u.y * v.z - u.z * v.y;
            out.y = u.z * v.x - u.x * v.z;
            out.z = u.x * v.y - u.y * v.x;
        }
    }
}

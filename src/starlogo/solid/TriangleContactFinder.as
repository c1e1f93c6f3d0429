package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.placePoints;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.TriangleKernel;

    use namespace engine;

    /**
     * Finds the contact of two triangles that touch, one of each model. If they meet at their borders, faces of both may separate them. A face
     * counts if it separates all of the other model at the contact: the next triangle may be on the other side of a seam. A small ball behind the
     * face, the probe, finds whether the other model has triangles there. What it tests is not counted.
     */
    internal final class TriangleContactFinder
    {
        // The radius of the probe, as a fraction of the bounding radius of the smaller triangle. Smaller: rounding decides. Larger: the probe meets what is
        // not at the contact.
        private static const PROBE:Number = 1e-4;

        // How far the probe is behind a plane, as a fraction of its radius. Smaller: the probe meets what is in the plane. Larger: it misses what leaves
        // the plane at a small angle, of the square root of twice this fraction.
        private static const PROBE_GAP:Number = 1e-6;

        // The corners of both triangles, in a's space.
        private var _cornersOfA:Vector.<Number> = new Vector.<Number>(9, true);
        private var _cornersOfB:Vector.<Number> = new Vector.<Number>(9, true);

        // Its shape is one triangle; then, for _triangleSearch, the probe. And the plane of the other triangle.
        private var _kernel:TriangleKernel = new TriangleKernel();
        private var _plane:TrianglePlane = new TrianglePlane();

        // The motion of a, as seen from b.
        private var _reversed:RelativeMotion = new RelativeMotion();

        // The probe in a's space, the placement of that space in b's, and what finds a model's triangles at the probe.
        private var _probe:Sphere = new Sphere(new Vector3D(), 0);
        private var _triangleSearch:StructureTriangleSearch = new StructureTriangleSearch(_kernel, new TreeCounts());
        private var _inverse:Placement = new Placement();

        // The motion of the probe, which stands; a search overwrites its times.
        private var _still:RelativeMotion = new RelativeMotion();

        /**
         * Finds the contact, in a's space.
         *
         * @param trees the trees of both models, and the pose of b in a's space
         * @param indexA the index of a's triangle
         * @param indexB the index of b's triangle
         * @param motion of b, which is where it is at the motion's time; its start must be 0
         * @param out receives the contact, with a normal from a to b
         */
        public function find(trees:TreePair, indexA:int, indexB:int, motion:RelativeMotion, out:ContactPoint):void
        {
            var placement:Placement = trees.pose.placement;
            var cullDistance:Number = trees.cullDistance(motion);
            var plane:TrianglePlane = _plane;
            trees.a.readTriangle(indexA, _cornersOfA);
            trees.b.readTriangle(indexB, _cornersOfB);
            placePoints(placement, _cornersOfB, 0, 9, _cornersOfB);
            _kernel.shape.setTriangle(_cornersOfA, 0);
            var radiusOfA:Number = _kernel.shape.boundingRadius;
            _kernel.shape.setTriangle(_cornersOfB, 0);
            _probe.radius = PROBE * Math.min(radiusOfA, _kernel.shape.boundingRadius);
            _kernel.findContact(_cornersOfA, motion, out);
            Placement.invert(placement, _inverse);
            plane.setTriangle(_cornersOfA, 0);
            if (plane.isHitFromFront(_kernel.shape, cullDistance, motion, out) && !hasTriangleBehind(trees, trees.b, _inverse, motion, out))
            {
                out.setNormal(plane.normal.x, plane.normal.y, plane.normal.z);
                return;
            }
            plane.setTriangle(_cornersOfB, 0);
            _kernel.shape.setTriangle(_cornersOfA, 0);
            _reversed.setReversed(motion);
            if (plane.isHitFromFront(_kernel.shape, cullDistance, _reversed, out) && !hasTriangleBehind(trees, trees.a, Placement.IDENTITY, RelativeMotion.NONE, out))
            {
                out.setNormal(-plane.normal.x, -plane.normal.y, -plane.normal.z);
            }
        }

        // Whether one of the trees has a triangle at a contact, at least in part behind the plane. The placement moves the probe into that tree's space.
        private function hasTriangleBehind(trees:TreePair, tree:BoxTree, placement:Placement, motion:RelativeMotion, contact:ContactPoint):Boolean
        {
            var back:Number = (1 + PROBE_GAP) * _probe.radius + 2 * trees.triangleMargin;
            var normal:Vector3D = _plane.normal;
            _probe.center.x = contact.x - motion.time * motion.x - back * normal.x;
            _probe.center.y = contact.y - motion.time * motion.y - back * normal.y;
            _probe.center.z = contact.z - motion.time * motion.z - back * normal.z;
            _still.latestTime = 1;
            return _triangleSearch.findFirst(tree, _kernel.setStructure(_probe, placement), _still) >= 0;
        }
    }
}

package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.StructureSweep;

    use namespace engine;

    /** Decides when a triangle of a model's leaf touches a solid sphere, capsule or box that moves. */
    internal final class SweptStructureTriangles extends StructureTriangles
    {
        private var _motion:RelativeMotion;
        private var _sweep:StructureSweep = new StructureSweep();

        // The index of the first number of the triangle that is touched first.
        private var _first:int = 0;

        /** Creates a test without a model. */
        public function SweptStructureTriangles()
        {
        }

        /**
         * Begins with a model that has triangles.
         *
         * @param structure at the beginning of its motion, in the space of the model; the call enlarges it
         * @param gap the same as for begin
         * @param motion the structure's motion from there; kept
         */
        public function beginMotion(model:SolidHierarchy, structure:BoundingStructure, gap:Number, motion:RelativeMotion):void
        {
            begin(model, structure, gap);
            _motion = motion;
            structure.widen(touching);
            tolerance = 0;
            _sweep.begin(structure, motion);
            extend(0, motion.x);
            extend(2, motion.y);
            extend(4, motion.z);
        }

        /** @inheritDoc */
        override public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var latest:Number = time;
            time = RelativeMotion.NEVER;
            for (var i:int = a.first; i < a.end && time > 0; i++)
            {
                if (!isNear(i))
                {
                    continue;
                }
                _sweep.setTriangle(solid.corners, 9 * i);
                _sweep.time = 0;
                if (!touches(i))
                {
                    _sweep.findTime(latest);
                }
                if (_sweep.time <= latest && _sweep.time < time)
                {
                    time = latest = _sweep.time;
                    _first = 9 * i;
                }
            }
            return time <= 1;
        }

        /** @inheritDoc */
        override public function findContact(out:ContactPoint):void
        {
            _sweep.setTriangle(solid.corners, _first);
            _sweep.findContact(_motion.time, out);
            out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
        }

        // Extends the extents to include the motion.
        private function extend(at:int, way:Number):void
        {
            if (way < 0)
            {
                extents[at] += way;
            }
            else
            {
                extents[int(at + 1)] += way;
            }
        }
    }
}

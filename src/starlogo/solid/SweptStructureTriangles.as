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

        // The first number of the triangle that is touched first.
        private var _first:int = 0;

        /** No model yet. */
        public function SweptStructureTriangles()
        {
        }

        /**
         * Begins with a model that has triangles.
         *
         * @param structure where its motion begins, in the space of the model; is made wider
         * @param gap as in begin
         * @param motion of the structure from there
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

        // Makes the extents those of the motion too.
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

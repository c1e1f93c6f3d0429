package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findBoxImpact;
    import starlogo.intersection.sweep.findTimeOfImpact;

    use namespace engine;

    /**
     * Tests two bodies that are structures, but not both spheres: whether they touch, when, and how (thesis §3.6).
     *
     * @private
     */
    public final class StructurePairs extends PairTests
    {
        /** The settings of the tests. */
        public var settings:StructureTests = new StructureTests();

        /** The number of tests since <code>resetCounts()</code>. The index has a bit for the kind of each of the two structures. */
        public var tests:Vector.<int> = new Vector.<int>(8, true);

        private var _finder:ContactFinder = new ContactFinder();

        // The reversed motion.
        private var _back:RelativeMotion = new RelativeMotion();

        // The extents of two bodies.
        private var _extentsA:Box = newBox();
        private var _extentsB:Box = newBox();

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            for (var i:int = 0; i < tests.length; i++)
            {
                tests[i] = 0;
            }
        }

        /** Writes the numbers of tests. */
        public function writeCounts(out:SearchCounts):void
        {
            out.sphereSphereTests = tests[1 << BoundingStructure.SPHERE];
            out.sphereCapsuleTests = tests[1 << BoundingStructure.SPHERE | 1 << BoundingStructure.CAPSULE];
            out.sphereBoxTests = tests[1 << BoundingStructure.SPHERE | 1 << BoundingStructure.BOX];
            out.capsuleCapsuleTests = tests[1 << BoundingStructure.CAPSULE];
            out.capsuleBoxTests = tests[1 << BoundingStructure.CAPSULE | 1 << BoundingStructure.BOX];
            out.boxBoxTests = tests[1 << BoundingStructure.BOX];
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            var structureA:BoundingStructure = a.structure();
            var structureB:BoundingStructure = b.structure();
            if (haveOuter(a, b) && !areOuterTouching(a, b))
            {
                return false;
            }
            noteTest(structureA, structureB);
            if (isByFaces(a, b))
            {
                readExtents(a, b);
                return boxBox(Box(structureA), Box(structureB), true) && boxBox(_extentsA, _extentsB);
            }
            return intersects(structureA, structureB);
        }

        /** @inheritDoc */
        override public function findTime(a:Body, b:Body, motion:RelativeMotion):void
        {
            var structureA:BoundingStructure = a.structure();
            var structureB:BoundingStructure = b.structure();
            noteTest(structureA, structureB);
            var byFaces:Boolean = isByFaces(a, b);
            findTimeOfStructures(structureA, structureB, byFaces, motion);
            if (motion.time != RelativeMotion.NEVER && byFaces)
            {
                _back.reverse(motion);
                findTimeOfStructures(structureA, structureB, byFaces, _back);
                findTimeOfBoth(a, b, motion);
            }
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && areTouching(a, b))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _finder.displacement.stopAt(motion);
            _finder.find(a.structure(), b.structure(), out);
        }

        /** @inheritDoc */
        override public function hasExactContact(a:Body, b:Body):Boolean
        {
            return !isByFaces(a, b);
        }

        private function areOuterTouching(a:Body, b:Body):Boolean
        {
            var outerA:OuterStructures = a.outer;
            var outerB:OuterStructures = b.outer;
            if (settings.spheresFirst)
            {
                noteTest(outerA.sphere, outerB.sphere);
                if (!sphereSphere(outerA.sphere, outerB.sphere))
                {
                    return false;
                }
            }
            if (settings.capsulesFirst && isOneBox(a, b))
            {
                noteTest(outerA.capsule, outerB.capsule);
                return capsuleCapsule(outerA.capsule, outerB.capsule);
            }
            return true;
        }

        private static function findTimeOfStructures(a:BoundingStructure, b:BoundingStructure, byFaces:Boolean, motion:RelativeMotion):void
        {
            if (byFaces)
            {
                findBoxImpact(Box(a), Box(b), motion, true);
                return;
            }
            findTimeOfImpact(a, b, motion);
        }

        // Finds the first time at which the faces and the extents of two boxes touch at once. Each touches during one interval of time. The
        // motion and the reversed motion already have the times of the faces.
        private function findTimeOfBoth(a:Body, b:Body, motion:RelativeMotion):void
        {
            var first:Number = motion.time;
            var last:Number = 1 - _back.time;
            readExtents(a, b);
            findTimeOfImpact(_extentsA, _extentsB, motion);
            findTimeOfImpact(_extentsA, _extentsB, _back);
            first = Math.max(first, motion.time);
            motion.time = first <= Math.min(last, 1 - _back.time) ? first : RelativeMotion.NEVER;
        }

        private function noteTest(a:BoundingStructure, b:BoundingStructure):void
        {
            tests[1 << a.kind | 1 << b.kind]++;
        }

        // Whether two boxes are tested by their faces. Then their extents are tested too, because the test of the faces alone finds touches of
        // boxes that are far from each other.
        private function isByFaces(a:Body, b:Body):Boolean
        {
            return settings.boxFacesOnly && a.form == BoundingStructure.BOX && b.form == BoundingStructure.BOX;
        }

        private function readExtents(a:Body, b:Body):void
        {
            a.writeExtents(_extentsA);
            b.writeExtents(_extentsB);
        }

        private static function newBox():Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        }

        private static function haveOuter(a:Body, b:Body):Boolean
        {
            return a.shape.outer != null && b.shape.outer != null;
        }

        private static function isOneBox(a:Body, b:Body):Boolean
        {
            return a.form == BoundingStructure.BOX || b.form == BoundingStructure.BOX;
        }
    }
}

package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findBoxImpact;
    import starlogo.intersection.sweep.findTimeOfImpact;
    import starlogo.libraries.BoundingStructuresLibrary;

    use namespace engine;

    /**
     * Every agent is the tightest fitting structure of its model, or the one that it collides as (§7.3), put through the agent's whole
     * transform (thesis §3).
     *
     * @private
     */
    public final class TightestFitStrategy extends ShapeStrategy
    {
        /** See StructureTests, whose settings these are. */
        public var spheresFirst:Boolean = true;

        /** @copy #spheresFirst */
        public var capsulesFirst:Boolean = false;

        /** @copy #spheresFirst */
        public var boxFacesOnly:Boolean = false;

        private var _greatLand:GreatLand;
        private var _finder:ContactFinder = new ContactFinder();
        private var _back:RelativeMotion = new RelativeMotion();

        // The interval in which all structures under way touch.
        private var _first:Number = 0;
        private var _last:Number = 1;

        // The extents of two rows.
        private var _extentsA:Box = newBox();
        private var _extentsB:Box = newBox();

        /**
         * @param greatLand has the structures
         */
        public function TightestFitStrategy(greatLand:GreatLand)
        {
            _greatLand = greatLand;
        }

        /** @inheritDoc */
        override public function kindOf(agent:Agent):int
        {
            return agent.structureKind;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var library:BoundingStructuresLibrary = _greatLand.boundingStructures;
            var model:String = shape.model;
            if (!library.has(model))
            {
                throw new ArgumentError(agent + ": its model was added while loadTightestFit was off; set it, and add the model again");
            }
            var isTightest:Boolean = shape.kind == Agent.ANY_KIND;
            shape.structure = isTightest ? library.tightestFit(model) : _greatLand.structureOfKind(model, shape.kind);
            shape.decides = true;
            shape.isSphere = shape.structure.kind == BoundingStructure.SPHERE;
            if (isTightest && !shape.isSphere && library.hasAll(model))
            {
                shape.outer = new OuterStructures();
                shape.outer.sphere = library.sphere(model).clone() as Sphere;
                shape.outer.capsule = library.capsule(model).clone() as Capsule;
                shape.outer.sphere.radius *= Tolerances.OUTER;
                shape.outer.capsule.radius *= Tolerances.OUTER;
            }
        }

        /** @inheritDoc */
        override public function boxOf(structure:BoundingStructure):Box
        {
            return structure as Box;
        }

        /** @inheritDoc */
        override public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var zs:Vector.<Number> = table.extents.z;
            var halfZs:Vector.<Number> = table.extents.halfZ;
            var boxes:Vector.<Box> = table.boxes;
            var placed:Vector.<int> = table.placedRevisions;
            var revisions:Vector.<int> = table.revisions;
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[slot];
            var atZ:Number = zs[row];
            var reachZ:Number = halfZs[row] + bins.slack;
            var box:Box = boxFacesOnly ? null : boxes[row];
            var shapes:Vector.<ModelShape> = table.shapes;
            var isSphere:Boolean = shapes[row].isSphere;
            var boxTests:int = 0;
            var sphereTests:int = 0;
            var kept:int = 0;
            if (box != null && placed[row] != revisions[row])
            {
                table.place(row);
            }
            for (var i:int = 0; i < count; i++)
            {
                // boxes are their own extents but for the heights
                var other:int = others[i];
                var otherRow:int = rowAt[other];
                var distance:Number = zs[otherRow] - atZ;
                var reach:Number = reachZ + halfZs[otherRow];
                if (distance > reach)
                {
                    continue;
                }
                if (distance < -reach)
                {
                    continue;
                }
                var otherBox:Box = boxes[otherRow];
                if (box != null && otherBox != null)
                {
                    boxTests++;
                    if (placed[otherRow] != revisions[otherRow])
                    {
                        table.place(otherRow);
                    }
                    if (!boxBox(box, otherBox))
                    {
                        continue;
                    }
                }
                else if (isSphere && shapes[otherRow].isSphere)
                {
                    // their circles on the ground are as wide as they are
                    sphereTests++;
                    var x:Number = bins.x[other] - bins.x[slot];
                    var y:Number = bins.y[other] - bins.y[slot];
                    reach = bins.radius[other] + bins.radius[slot];
                    if (x * x + y * y + distance * distance > reach * reach && !areSpheresTouching(table, row, otherRow))
                    {
                        continue;
                    }
                }
                else if (!areNear(table.extents, bins, row, otherRow) || !areTouching(table, row, otherRow))
                {
                    continue;
                }
                others[kept] = other;
                kept++;
            }
            counts.tests[BoundingStructure.BOX << 2 | BoundingStructure.BOX] += boxTests;
            counts.tests[0] += sphereTests;
            return kept;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                counts.tests[0]++;
                return areSpheresTouching(table, a, b);
            }
            var structureA:BoundingStructure = table.structureOf(a);
            var structureB:BoundingStructure = table.structureOf(b);
            if (haveOuter(table, a, b) && !areOuterTouching(table, a, b))
            {
                return false;
            }
            noteTest(structureA, structureB);
            if (isByFaces(table, a, b))
            {
                readExtents(table, a, b);
                return boxBox(Box(structureA), Box(structureB), true) && boxBox(_extentsA, _extentsB);
            }
            return intersects(structureA, structureB);
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            var structureA:BoundingStructure = table.structureOf(a);
            var structureB:BoundingStructure = table.structureOf(b);
            noteTest(structureA, structureB);
            var byFaces:Boolean = isByFaces(table, a, b);
            findTimeOfStructures(structureA, structureB, byFaces, motion);
            if (motion.time != RelativeMotion.NEVER && (byFaces || haveOuter(table, a, b)))
            {
                _back.reverse(motion);
                findTimeOfStructures(structureA, structureB, byFaces, _back);
                findTimeOfAll(table, a, b, byFaces, motion);
            }
            // no rounding hides what stands there
            if (motion.time == RelativeMotion.NEVER && areTouching(table, a, b))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _finder.displacement.stopAt(motion);
            _finder.find(table.structureOf(a), table.structureOf(b), out);
        }

        /** @inheritDoc */
        override public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            if ((spheresFirst || capsulesFirst) && haveOuter(table, a, b))
            {
                return false;
            }
            return !isByFaces(table, a, b);
        }

        /** @inheritDoc */
        override public function get touchesAcrossGaps():Boolean
        {
            return boxFacesOnly;
        }

        private function areOuterTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var outerA:OuterStructures = table.outer[a];
            var outerB:OuterStructures = table.outer[b];
            if (spheresFirst)
            {
                noteTest(outerA.sphere, outerB.sphere);
                if (!sphereSphere(outerA.sphere, outerB.sphere))
                {
                    return false;
                }
            }
            if (capsulesFirst && isOneBox(table, a, b))
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

        // Finds when all that decides touches; the structures' times, on the motion and on the way back, are there. Each two touch during one interval.
        private function findTimeOfAll(table:AgentTable, a:int, b:int, byFaces:Boolean, motion:RelativeMotion):void
        {
            _first = motion.time;
            _last = 1 - _back.time;
            if (byFaces)
            {
                readExtents(table, a, b);
                limitTimes(_extentsA, _extentsB, motion);
            }
            var outerA:OuterStructures = table.outer[a];
            var outerB:OuterStructures = table.outer[b];
            var areOuter:Boolean = haveOuter(table, a, b);
            if (areOuter && spheresFirst)
            {
                noteTest(outerA.sphere, outerB.sphere);
                limitTimes(outerA.sphere, outerB.sphere, motion);
            }
            if (areOuter && capsulesFirst && isOneBox(table, a, b))
            {
                noteTest(outerA.capsule, outerB.capsule);
                limitTimes(outerA.capsule, outerB.capsule, motion);
            }
            motion.time = _first <= _last ? _first : RelativeMotion.NEVER;
        }

        private function limitTimes(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):void
        {
            findTimeOfImpact(a, b, motion);
            findTimeOfImpact(a, b, _back);
            _first = Math.max(_first, motion.time);
            _last = Math.min(_last, 1 - _back.time);
        }

        private function noteTest(a:BoundingStructure, b:BoundingStructure):void
        {
            counts.tests[a.kind << 2 | b.kind]++;
        }

        // Whether the faces of two boxes decide, and their extents, without which boxes far from each other would touch.
        private function isByFaces(table:AgentTable, a:int, b:int):Boolean
        {
            return boxFacesOnly && table.shapes[a].structure.kind == BoundingStructure.BOX && table.shapes[b].structure.kind == BoundingStructure.BOX;
        }

        private function readExtents(table:AgentTable, a:int, b:int):void
        {
            table.readExtents(a, _extentsA);
            table.readExtents(b, _extentsB);
        }

        private static function newBox():Box
        {
            return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        }

        private static function haveOuter(table:AgentTable, a:int, b:int):Boolean
        {
            return table.shapes[a].outer != null && table.shapes[b].outer != null;
        }

        private static function isOneBox(table:AgentTable, a:int, b:int):Boolean
        {
            return table.shapes[a].structure.kind == BoundingStructure.BOX || table.shapes[b].structure.kind == BoundingStructure.BOX;
        }
    }
}

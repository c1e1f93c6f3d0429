package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.motion.Touch;
    import starlogo.motion.TouchFinder;
    import starlogo.motion.Way;
    import starlogo.motion.boxBoxTouch;
    import starlogo.motion.firstTouch;

    use namespace engine;

    /** Every agent is the tightest fitting structure of its model, or the one that it collides as (§7.3), put through the agent's whole transform (thesis §3). */
    internal final class TightestFitStrategy extends ShapeStrategy
    {
        /** How two structures are tested. */
        public var tests:StructureTests = new StructureTests();

        private var _greatLand:GreatLand;
        private var _finder:TouchFinder = new TouchFinder();
        private var _back:Way = new Way();

        // How often each test was made in this search, by the kinds of the structures.
        private var _tests:Vector.<int> = new Vector.<int>(16, true);

        /**
         * @param greatLand has the structures
         */
        public function TightestFitStrategy(greatLand:GreatLand)
        {
            _greatLand = greatLand;
        }

        /** @inheritDoc */
        override public function bindModel(shape:WorldShape):void
        {
            var agent:Agent = shape.agent;
            var library:BoundingStructuresLibrary = _greatLand.boundingStructures;
            if (!library.has(agent.shape))
            {
                throw new ArgumentError(agent + ": its model was added while loadTightestFit was off; set it, and add the model again");
            }
            var kind:int = agent.structureKind;
            shape.structure = kind == Agent.ANY_KIND ? library.tightestFit(agent.shape) : _greatLand.structureOfKind(agent.shape, kind);
            shape.structureKind = kind;
            shape.worldStructure = shape.structure.clone();
            shape.placedRevision = shape.placedExtentsRevision = -1;
            shape.outer = null;
            if (kind == Agent.ANY_KIND && shape.structure.kind != BoundingStructure.SPHERE && library.hasAll(agent.shape))
            {
                shape.outer = new OuterStructures(library.sphere(agent.shape), library.capsule(agent.shape));
            }
            takeStructure(shape);
        }

        /** Has the structure of a shape decide, which was bound before. */
        public function takeStructure(shape:WorldShape):void
        {
            shape.isSphere = shape.structure.kind == BoundingStructure.SPHERE;
            shape.box = shape.outer == null ? shape.worldStructure as Box : null;
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            if (shape.structureKind != shape.agent.structureKind)
            {
                bindModel(shape);
            }
            shape.takeExtentsOf(shape.structure);
            if (shape.isSphere)
            {
                shape.radius = shape.halfX * Tolerances.TOUCHING;
            }
        }

        /** @inheritDoc */
        override public function get boxFacesOnly():Boolean
        {
            return tests.boxFacesOnly;
        }

        /** @inheritDoc */
        override public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            place(a);
            place(b);
            if (a.outer != null)
            {
                if (b.outer != null && !passPreliminaryTests(a, b))
                {
                    return false;
                }
            }
            var structureA:BoundingStructure = a.worldStructure;
            var structureB:BoundingStructure = b.worldStructure;
            _tests[structureA.kind << 2 | structureB.kind]++;
            if (structureA.kind == BoundingStructure.BOX && structureB.kind == BoundingStructure.BOX)
            {
                return boxBox(Box(structureA), Box(structureB), tests.boxFacesOnly);
            }
            return intersects(structureA, structureB);
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            for (var i:int = 0; i < _tests.length; i++)
            {
                _tests[i] = 0;
            }
        }

        /** @inheritDoc */
        override public function countInto(statistics:CollisionStatistics):void
        {
            statistics.sphereSphereTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.SPHERE);
            statistics.sphereCapsuleTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            statistics.sphereBoxTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.BOX);
            statistics.capsuleCapsuleTests += testsOf(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            statistics.capsuleBoxTests += testsOf(BoundingStructure.CAPSULE, BoundingStructure.BOX);
            statistics.boxBoxTests += testsOf(BoundingStructure.BOX, BoundingStructure.BOX);
        }

        /** @inheritDoc */
        override public function firstOverlap(a:WorldShape, b:WorldShape, way:Way):Number
        {
            place(a);
            place(b);
            var structureA:BoundingStructure = a.worldStructure;
            var structureB:BoundingStructure = b.worldStructure;
            _tests[structureA.kind << 2 | structureB.kind]++;
            if (tests.boxFacesOnly && structureA.kind == BoundingStructure.BOX && structureB.kind == BoundingStructure.BOX)
            {
                return boxBoxTouch(Box(structureA), Box(structureB), way, true);
            }
            var hasOuter:Boolean = a.outer != null && b.outer != null;
            var time:Number = firstTouch(structureA, structureB, way);
            if (time != Way.NEVER && hasOuter)
            {
                time = firstTouchOfAll(a, b, way, time);
            }
            if (time == Way.NEVER)
            {
                // no rounding hides what stands there
                return intersects(structureA, structureB) && (!hasOuter || passPreliminaryTests(a, b)) ? 1 : Way.NEVER;
            }
            return time;
        }

        /** @inheritDoc */
        override public function findTouch(a:WorldShape, b:WorldShape, way:Way, time:Number, out:Touch):void
        {
            place(a);
            place(b);
            _finder.find(a.worldStructure, b.worldStructure, way.startX + time * way.x, way.startY + time * way.y,
                    way.startZ + time * way.z, out);
        }

        private static function place(shape:WorldShape):void
        {
            if (shape.placedRevision != shape.revision)
            {
                shape.placeStructure();
            }
        }

        // When the structures that passPreliminaryTests looks at touch as well. Each two of them do so in one piece of the way.
        private function firstTouchOfAll(a:WorldShape, b:WorldShape, way:Way, time:Number):Number
        {
            var end:Number = lastTouch(a.worldStructure, b.worldStructure, way);
            if (tests.spheresFirst)
            {
                _tests[BoundingStructure.SPHERE << 2 | BoundingStructure.SPHERE]++;
                time = Math.max(time, firstTouch(a.outer.worldSphere, b.outer.worldSphere, way));
                end = Math.min(end, lastTouch(a.outer.worldSphere, b.outer.worldSphere, way));
            }
            if (tests.capsulesFirst && (a.structure.kind == BoundingStructure.BOX || b.structure.kind == BoundingStructure.BOX))
            {
                _tests[BoundingStructure.CAPSULE << 2 | BoundingStructure.CAPSULE]++;
                time = Math.max(time, firstTouch(a.outer.worldCapsule, b.outer.worldCapsule, way));
                end = Math.min(end, lastTouch(a.outer.worldCapsule, b.outer.worldCapsule, way));
            }
            return time <= end ? time : Way.NEVER;
        }

        private function lastTouch(a:BoundingStructure, b:BoundingStructure, way:Way):Number
        {
            _back.takePart(way, 1, 0);
            return 1 - firstTouch(a, b, _back);
        }

        private function passPreliminaryTests(a:WorldShape, b:WorldShape):Boolean
        {
            if (tests.spheresFirst)
            {
                _tests[BoundingStructure.SPHERE << 2 | BoundingStructure.SPHERE]++;
                if (!sphereSphere(a.outer.worldSphere, b.outer.worldSphere))
                {
                    return false;
                }
            }
            if (tests.capsulesFirst && (a.structure.kind == BoundingStructure.BOX || b.structure.kind == BoundingStructure.BOX))
            {
                _tests[BoundingStructure.CAPSULE << 2 | BoundingStructure.CAPSULE]++;
                return capsuleCapsule(a.outer.worldCapsule, b.outer.worldCapsule);
            }
            return true;
        }

        private function testsOf(kind:int, otherKind:int):int
        {
            var count:int = _tests[kind << 2 | otherKind];
            return kind == otherKind ? count : count + _tests[otherKind << 2 | kind];
        }
    }
}

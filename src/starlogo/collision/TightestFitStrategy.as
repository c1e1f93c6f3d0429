package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;
    import starlogo.libraries.BoundingStructuresLibrary;

    use namespace engine;

    /** Every agent is the tightest fitting structure of its model, put through the agent's whole transform (thesis §3). */
    internal final class TightestFitStrategy extends ShapeStrategy
    {
        /** How two structures are tested. */
        public var tests:StructureTests = new StructureTests();

        private var _greatLand:GreatLand;

        // How often each test was made in this search, by the kinds of the structures; two boxes apart.
        private var _tests:Vector.<int> = new Vector.<int>(16, true);
        private var _boxBoxTests:int = 0;

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
            shape.structure = library.tightestFit(agent.shape);
            shape.worldStructure = shape.structure.clone();
            shape.worldBox = shape.worldStructure as Box;
            shape.isSphere = shape.structure.kind == BoundingStructure.SPHERE;
            if (!shape.isSphere && library.hasAll(agent.shape))
            {
                shape.outer = new OuterStructures(library.sphere(agent.shape), library.capsule(agent.shape));
            }
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            var placement:Placement = shape.agent.worldPlacement();
            var world:BoundingStructure = shape.structure.place(placement, shape.worldStructure);
            if (shape.isSphere)
            {
                var sphere:Sphere = Sphere(world);
                shape.x = sphere.center.x;
                shape.y = sphere.center.y;
                shape.z = sphere.center.z;
                shape.halfX = shape.halfY = shape.halfZ = sphere.radius;
                shape.radius = sphere.radius * Tolerances.TOUCHING;
                return;
            }
            shape.takeExtentsOf(world);
            if (shape.outer != null)
            {
                shape.outer.place(placement);
            }
        }

        /** @inheritDoc */
        override public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            if (a.outer != null)
            {
                if (b.outer != null && !passPreliminaryTests(a, b))
                {
                    return false;
                }
            }
            var boxA:Box = a.worldBox;
            var boxB:Box = b.worldBox;
            if (boxA != null)
            {
                if (boxB != null)
                {
                    _boxBoxTests++;
                    return boxBox(boxA, boxB, tests.boxFacesOnly);
                }
            }
            var structureA:BoundingStructure = a.worldStructure;
            var structureB:BoundingStructure = b.worldStructure;
            _tests[structureA.kind << 2 | structureB.kind]++;
            return intersects(structureA, structureB);
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            _boxBoxTests = 0;
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
            statistics.boxBoxTests += _boxBoxTests;
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
            if (tests.capsulesFirst && (a.worldBox != null || b.worldBox != null))
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

package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;
    import starlogo.libraries.BoundingStructuresLibrary;

    use namespace engine;

    /**
     * Takes every agent for the tightest fitting sphere, box or capsule of its model (thesis §3), put through the agent's
     * whole transform.
     *
     * <p>It is built on the BinCollider (§3.7): an agent is in the bins that the extents of its structure reach into, and a
     * structure is put into the world when its agent has changed, not for each pair. Pairs that overlap in all three
     * extents are decided by the exact test of their kinds (§3.6). Where GreatLand has loaded all bounding structures, two
     * structures that are not spheres are tested only if spheres around them meet (§7.5).</p>
     */
    public class TightestFitCollider extends BinCollider
    {
        // How often each test was made in this search, by the kinds of the structures.
        private var _tests:Vector.<int> = new Vector.<int>(16, true);
        private var _boxBoxTests:int;

        // Pairs that were not two spheres.
        internal var _pairsOfOthers:int;

        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadTightestFit
         * @throws ArgumentError if it is null
         */
        public function TightestFitCollider(greatLand:GreatLand)
        {
            super(greatLand);
        }

        /** @private */
        override internal function adopt(body:Body):void
        {
            var agent:Agent = body.agent;
            var library:BoundingStructuresLibrary = _greatLand.boundingStructures;
            _greatLand.requireModel(agent);
            if (!library.has(agent.shape))
            {
                throw new ArgumentError(agent + ": its model was added while loadTightestFit was off; set it, and add the model again");
            }
            body.structure = library.tightestFit(agent.shape);
            body.world = body.structure.clone();
            body.worldBox = body.world as Box;
            body.isSphere = body.structure.kind == BoundingStructure.SPHERE;
            if (!body.isSphere && library.hasAll(agent.shape))
            {
                body.outerSphere = library.sphere(agent.shape);
                body.worldOuterSphere = body.outerSphere.clone() as Sphere;
            }
        }

        /** @private */
        override internal function place(body:Body):void
        {
            var placement:Placement = body.agent.worldPlacement();
            var world:BoundingStructure = body.structure.place(placement, body.world);
            if (body.isSphere)
            {
                var sphere:Sphere = Sphere(world);
                body.x = sphere.center.x;
                body.y = sphere.center.y;
                body.z = sphere.center.z;
                body.halfX = body.halfY = body.halfZ = sphere.radius;
                return;
            }
            body.takeExtentsOf(body.world);
            if (body.outerSphere != null)
            {
                body.outerSphere.place(placement, body.worldOuterSphere);
            }
        }

        /** @private */
        override internal function test(a:Body, b:Body):Boolean
        {
            _pairsOfOthers++;
            var distance:Number = a.z - b.z;
            var reach:Number = a.halfZ + b.halfZ;
            if (distance > reach || distance < -reach)
            {
                return false;
            }
            if (a.worldOuterSphere != null && b.worldOuterSphere != null)
            {
                _tests[0]++;
                if (!sphereSphere(a.worldOuterSphere, b.worldOuterSphere))
                {
                    return false;
                }
            }
            var boxA:Box = a.worldBox;
            var boxB:Box = b.worldBox;
            if (boxA != null && boxB != null)
            {
                _boxBoxTests++;
                return boxBox(boxA, boxB);
            }
            _tests[a.world.kind << 2 | b.world.kind]++;
            return intersects(a.world, b.world);
        }

        /** @private */
        override internal function resetCounts():void
        {
            _pairsOfOthers = _boxBoxTests = 0;
            for (var i:int = 0; i < _tests.length; i++)
            {
                _tests[i] = 0;
            }
        }

        /** @private */
        override internal function countTests(statistics:CollisionStatistics):void
        {
            statistics.sphereSphereTests = statistics.candidatePairs - _pairsOfOthers + testsOf(BoundingStructure.SPHERE, BoundingStructure.SPHERE);
            statistics.sphereCapsuleTests = testsOf(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            statistics.sphereBoxTests = testsOf(BoundingStructure.SPHERE, BoundingStructure.BOX);
            statistics.capsuleCapsuleTests = testsOf(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            statistics.capsuleBoxTests = testsOf(BoundingStructure.CAPSULE, BoundingStructure.BOX);
            statistics.boxBoxTests = _boxBoxTests;
        }

        private function testsOf(kind:int, otherKind:int):int
        {
            var count:int = _tests[kind << 2 | otherKind];
            return kind == otherKind ? count : count + _tests[otherKind << 2 | kind];
        }
    }
}

package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** The classes with only some questions answer as an AgentQueries does. */
    public class SeenAgentsTest
    {
        private var _land:GreatLand;
        private var _agents:Vector.<Agent>;
        private var _random:SeededRandom;

        [Before]
        public function makeAgents():void
        {
            _random = new SeededRandom(7407);
            _land = landOf(BuiltInModel.cube(), BuiltInModel.sphere(), BuiltInModel.cylinder());
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < 60; i++)
            {
                var agent:Agent = agentAt(["cube", "sphere", "cylinder"][i % 3], _random.between(-6, 6), _random.between(-6, 6), _random.between(-1, 1));
                agent.heading = _random.between(0, 360);
                agent.hierarchical = agent.shape == "cube";
                _agents.push(agent);
            }
        }

        [Test]
        public function theirAnswersAreThoseOfAllQuestions():void
        {
            var system:CombinationCollider = new CombinationCollider(_land);
            var level:LevelShapes = newLevel();
            var collision:Collision = new Collision(system);
            for each (var isExact:Boolean in [false, true])
            {
                system.exact = level.exact = isExact;
                system.maxDepth = level.maxDepth = 3;
                assertEquals("the depth, and whether triangles decide", "3, " + isExact, level.maxDepth + ", " + level.exact);
                compare(system, system);
                compare(system, collision);
                compare(system, level);
            }
        }

        // The cubes are trees, and all others are structures, as in a CombinationCollider with these agents.
        private function newLevel():LevelShapes
        {
            var level:LevelShapes = new LevelShapes();
            level.addModel(BuiltInModel.cube());
            level.addStructure("sphere", _land.boundingStructures.tightestFit("sphere"));
            level.addStructure("cylinder", _land.boundingStructures.tightestFit("cylinder"));
            return level;
        }

        // Both ask the same questions in the same order. Motions are made twice from the same place.
        private function compare(system:CombinationCollider, source:Object):void
        {
            var all:AgentQueries = new AgentQueries(system);
            var seen:SeenAgents = new SeenAgents(source);
            var places:AgentPlaces = new AgentPlaces(seen);
            var rays:AgentRays = new AgentRays(seen);
            var motions:AgentMotions = new AgentMotions(seen);
            var met:int = 0;
            all.update(_agents);
            seen.update(_agents);
            for (var i:int = 0; i < 40; i++)
            {
                var agent:Agent = _agents[i];
                var at:Vector3D = new Vector3D(_random.between(-7, 7), _random.between(-7, 7), _random.between(-1, 1));
                var way:Vector3D = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-0.2, 0.2));
                assertStrictlyEquals(all.nearest(agent), places.nearest(agent));
                assertStrictlyEquals(all.nearestToPoint(at, 4), places.nearestToPoint(at, 4));
                assertEquals(all.near(agent, 3).join(), places.near(agent, 3).join());
                assertEquals(all.nearestFew(agent, 4).join(), places.nearestFew(agent, 4).join());
                assertEquals(all.nearPoint(at, 3).join(), places.nearPoint(at, 3).join());
                assertEquals(all.countNear(agent, 3), places.countNear(agent, 3));
                assertEquals(all.countNearPoint(at, 3), places.countNearPoint(at, 3));
                assertEquals(all.inCone(agent, 5, 80).join(), places.inCone(agent, 5, 80).join());
                met += compareHits(all.cast(at, way), rays.cast(at, way));
                assertEquals(all.castAll(at, way).length, rays.castAll(at, way).length);
                assertEquals(all.castAll(at, way, Infinity, null, null, true).length, rays.castAll(at, way, Infinity, null, null, true).length);
                assertEquals(all.canSee(agent, _agents[i + 1]), rays.canSee(agent, _agents[i + 1]));
                var ball:Sphere = new Sphere(at, 0.3);
                assertEquals(timeOf(all.castShape(ball, way.x, way.y, way.z)), timeOf(motions.castShape(ball, way.x, way.y, way.z)));
                assertEquals(all.castShapeAll(ball, way.x, way.y, way.z).length, motions.castShapeAll(ball, way.x, way.y, way.z).length);
                assertEquals(timeOf(all.castAgent(agent, way.x, way.y, way.z)), timeOf(motions.castAgent(agent, way.x, way.y, way.z)));
                assertEquals(all.castAgentAll(agent, way.x, way.y, way.z).length, motions.castAgentAll(agent, way.x, way.y, way.z).length);
            }
            assertTrue(met > 5);
            assertTrue(met < 40);
            compareMotions(all, motions);
        }

        // The mover is in neither list, so the others stay where they are.
        private function compareMotions(all:AgentQueries, motions:AgentMotions):void
        {
            var first:Agent = agentAt("sphere", 0, 0, 8);
            var second:Agent = agentAt("sphere", 0, 0, 8);
            var contact:Contact = new Contact();
            for (var i:int = 0; i < 20; i++)
            {
                var dx:Number = _random.between(-2, 2);
                var dy:Number = _random.between(-2, 2);
                assertEquals(all.moveUntilTouch(first, dx, dy, -1), motions.moveUntilTouch(second, dx, dy, -1, null, contact));
                assertEquals(all.slide(first, dy, dx, 0.4), motions.slide(second, dy, dx, 0.4));
                assertEquals(all.walk(first, dx, dx).stands, motions.walk(second, dx, dx).stands);
                assertEquals([first.x, first.y, first.z].join(), [second.x, second.y, second.z].join());
            }
        }

        private static function compareHits(expected:RayHit, found:RayHit):int
        {
            if (expected == null || found == null)
            {
                assertStrictlyEquals(expected, found);
                return 0;
            }
            assertStrictlyEquals(expected.agent, found.agent);
            assertEquals(expected.distance, found.distance);
            assertEquals(expected.triangle, found.triangle);
            return 1;
        }

        private static function timeOf(hit:ShapeHit):Number
        {
            return hit == null ? -1 : hit.time;
        }

        [Test]
        public function acceptsMayAskThemAgain():void
        {
            var seen:SeenAgents = new SeenAgents(new CombinationCollider(_land));
            var places:AgentPlaces = new AgentPlaces(seen);
            var rays:AgentRays = new AgentRays(seen);
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                rays.canSee(agent, _agents[0]);
                return places.nearest(agent) != null;
            };
            seen.update(_agents);
            assertEquals(59, places.near(_agents[0], 100, filter).length);
            filter.accepts = function(agent:Agent):Boolean
            {
                seen.update(_agents);
                return true;
            };
            assertThrows(IllegalOperationError, "accepts", places.near, _agents[0], 100, filter);
        }

        [Test]
        public function whatTwoNeedIsAddedOnce():void
        {
            var seen:SeenAgents = new SeenAgents(new BinCollider());
            var added:int = 0;
            var add:Function = function(narrowPhase:Object):void
            {
                added++;
            };
            seen.needTests(add);
            seen.needTests(add);
            assertEquals(1, added);
        }

        [Test]
        public function oneAgentIsReadAgain():void
        {
            var seen:SeenAgents = new SeenAgents(new BinCollider());
            var rays:AgentRays = new AgentRays(seen);
            seen.update(new <Agent>[_agents[0]]);
            _agents[0].moveTo(20, 0, 0);
            assertNull(rays.cast(new Vector3D(20, 0, 9), new Vector3D(0, 0, -1)));
            seen.refresh(_agents[0]);
            assertStrictlyEquals(_agents[0], rays.cast(new Vector3D(20, 0, 9), new Vector3D(0, 0, -1)).agent);
        }

        [Test]
        public function aRayMeetsTheGround():void
        {
            var ground:Terrain = new Terrain(4, 4);
            var collision:Collision = new Collision(new BinCollider());
            for each (var source:Object in [new LevelShapes(), new BinCollider(), collision])
            {
                var seen:SeenAgents = new SeenAgents(source);
                seen.terrain = ground;
                assertStrictlyEquals(ground, seen.terrain);
                seen.update(new <Agent>[]);
                assertStrictlyEquals(ground.agent, new AgentRays(seen).cast(new Vector3D(1, 1, 9), new Vector3D(0, 0, -1)).agent);
            }
            assertStrictlyEquals(ground, collision.terrain);
        }

        [Test]
        public function whatIsWrongIsRefused():void
        {
            assertThrows(ArgumentError, "AgentRays", makeQueries, new LevelShapes());
            assertThrows(ArgumentError, "a Collision", makeSeen, _land);
            assertThrows(ArgumentError, "a Collision", makeSeen, null);
            assertThrows(ArgumentError, "seen", makeRays, null);
            var seen:SeenAgents = new SeenAgents(new LevelShapes());
            assertThrows(IllegalOperationError, "update", new AgentPlaces(seen).nearest, _agents[0]);
        }

        private static function makeQueries(source:Object):void
        {
            new AgentQueries(source);
        }

        private static function makeSeen(source:Object):void
        {
            new SeenAgents(source);
        }

        private static function makeRays(seen:SeenAgents):void
        {
            new AgentRays(seen);
        }

        [Test(expects="RangeError")]
        public function aLevelIsNotTestedToNoDepth():void
        {
            new LevelShapes().maxDepth = 0;
        }

        [Test]
        public function aLevelTakesWhatReplacesAShapeAndWhatIsPosed():void
        {
            var box:Model = BuiltInModel.box(2, 2, 2);
            var level:LevelShapes = new LevelShapes();
            var seen:SeenAgents = new SeenAgents(level);
            var rays:AgentRays = new AgentRays(seen);
            var agents:Vector.<Agent> = new <Agent>[new Agent(box.name), agentAt("post", 9, 0, 0)];
            level.exact = true;
            level.addModel(box);
            level.addStructure("post", new Capsule(new Vector3D(), new Vector3D(0, 0, 4), 1));
            assertHeights(2, 5);
            level.addStructure("post", new Hull(new <Number>[-1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 3]));
            assertHeights(2, 3);
            var lower:Vector.<Number> = box.vertices.concat();
            for (var i:int = 2; i < lower.length; i += 3)
            {
                lower[i] /= 2;
            }
            box.pose(lower);
            assertHeights(1, 3);
            level.addStructure(box.name, new Sphere(new Vector3D(), 4));
            level.addModel(new Model("post", lower, box.triangles, Model.AS_GIVEN));
            assertHeights(4, 1);

            function assertHeights(...heights):void
            {
                seen.update(agents);
                for (var i:int = 0; i < 2; i++)
                {
                    assertEquals(heights[i], 9 - Math.round(1e9 * rays.cast(new Vector3D(9 * i, 0, 9), new Vector3D(0, 0, -1)).distance) / 1e9);
                }
            }
        }

        [Test]
        public function aLevelIsPreparedForWhatIsAskedAlone():void
        {
            var level:LevelShapes = new LevelShapes();
            var seen:SeenAgents = new SeenAgents(level);
            var box:Agent = new Agent(BuiltInModel.cube().name);
            level.exact = true;
            level.addModel(BuiltInModel.cube());
            seen.update(new <Agent>[box]);
            assertEquals(9, new AgentRays(seen).cast(new Vector3D(0, 0, 10), new Vector3D(0, 0, -1)).distance);
            assertFalse(seen.currentBodyOf(box).shape.tree.isExactPrepared);
            assertEquals(0, new AgentRays(seen).cast(new Vector3D(0, 0, 0.5), new Vector3D(0, 0, -1)).distance);
            assertTrue(seen.currentBodyOf(box).shape.tree.isExactPrepared);
            level.prepareExact = true;
            level.addModel(BuiltInModel.cube());
            seen.update(new <Agent>[box]);
            assertTrue(seen.currentBodyOf(box).shape.tree.isExactPrepared);
        }

        [Test]
        public function aLevelRefusesWhatItDoesNotKnow():void
        {
            var level:LevelShapes = new LevelShapes();
            var seen:SeenAgents = new SeenAgents(level);
            assertThrows(ArgumentError, /model must/, level.addModel, null);
            assertThrows(ArgumentError, "a name", level.addStructure, "", new Sphere(new Vector3D(), 1));
            assertThrows(ArgumentError, "not null", level.addStructure, "ball", null);
            assertThrows(ArgumentError, "LevelShapes", seen.update, new <Agent>[new Agent("ball")]);
        }
    }
}

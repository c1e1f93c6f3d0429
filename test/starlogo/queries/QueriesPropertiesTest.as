package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ModelLoader;
    import starlogo.terrain.Terrain;
    import support.OwnVectorSystem;
    import support.assertClose;
    import support.assertThrows;
    import support.landOf;

    /** What holds for questions beside their answers: what they change, refuse and follow. */
    public class QueriesPropertiesTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _queries:AgentQueries = new AgentQueries(new TightestFitCollider(_greatLand));

        [Before]
        public function begin():void
        {
            var random:SeededRandom = new SeededRandom(2220);
            for (var i:int = 0; i < 300; i++)
            {
                var agent:Agent = new Agent(random.pick(["sphere", "cube", "cylinder"]), random.pick(["bears", "balls"]));
                agent.moveTo(random.between(-9, 9), random.between(-9, 9), random.integer(0, 3));
                agent.size = random.between(0.25, 2);
                agent.heading = random.integer(0, 7) * 45;
                agent.hierarchical = random.chance(0.3);
                _agents.push(agent);
            }
            _queries.update(_agents);
        }

        [Test]
        public function askingChangesNothing():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            var collision:Collision = new Collision(collider);
            var calls:int = 0;
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent):void
                {
                    calls++;
                });
            _agents[0].sweeps = true;
            _agents[0].jumpTo(-100, 0, 0.5);
            collision.update(_agents);
            var before:String = String(collider.statistics.hierarchyTests + " " + collider.statistics.nodeVisits + " " + collision.statistics.nodeVisits);
            var counted:int = calls;
            var queries:AgentQueries = new AgentQueries(collision);
            _agents[0].moveTo(100, 0, 0.5);
            queries.update(_agents);
            for each (var agent:Agent in _agents)
            {
                queries.touching(agent);
                queries.moved(agent);
            }
            assertEquals(before, collider.statistics.hierarchyTests + " " + collider.statistics.nodeVisits + " " + collision.statistics.nodeVisits);
            calls = 0;
            collision.update(_agents);
            assertTrue("the motion counts: " + calls + " after " + counted, calls > counted);
        }

        [Test]
        public function whatIsRefusedChangesNothing():void
        {
            var before:String = answers();
            var stranger:Agent = new Agent("unicorn");
            assertThrows(ArgumentError, /agents must/, _queries.update, null);
            assertThrows(ArgumentError, /agents\[300\].* null/, _queries.update, _agents.concat(new <Agent>[null]));
            assertThrows(ArgumentError, /agents\[3\] and agents\[300\]/, _queries.update, _agents.concat(new <Agent>[_agents[3]]));
            assertThrows(ArgumentError, /no model "unicorn"/, _queries.update, new <Agent>[_agents[1], stranger, _agents[0]]);
            assertEquals(before, answers());
            _agents[5].shape = "unicorn";
            assertThrows(ArgumentError, /no model "unicorn"/, _queries.update, _agents);
            assertThrows(ArgumentError, /no model "unicorn"/, _queries.moved, _agents[5]);
            assertThrows(ArgumentError, /no model "unicorn"/, _queries.touching, _agents[5]);
            assertThrows(ArgumentError, /not in the list/, _queries.moved, stranger);
            assertThrows(ArgumentError, /agent (is needed|must)/, _queries.near, null, 1);
            assertThrows(ArgumentError, /agent (is needed|must)/, _queries.touching, null);
            assertThrows(ArgumentError, /point (is needed|must)/, _queries.nearPoint, null, 1);
            assertThrows(RangeError, /finite/, _queries.countNearPoint, new Vector3D(NaN, 0, 0), 1);
            assertThrows(RangeError, /radius must be 0 or more, not -1/, _queries.near, _agents[0], -1);
            assertThrows(RangeError, /radius must be 0 or more, not NaN/, _queries.nearest, _agents[0], NaN);
            assertThrows(RangeError, /count must be 0 or more, not -2/, _queries.nearestOf, _agents[0], -2);
            assertThrows(ArgumentError, /agent (is needed|must)/, _queries.nearestOf, null, 2);
            assertThrows(ArgumentError, /agent (is needed|must)/, _queries.touchesAny, null);
            assertThrows(RangeError, /degrees must be 0 or more, not -3/, _queries.inCone, _agents[0], 1, -3);
            assertThrows(ArgumentError, /not /, _queries.overlapping, new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1));
            var sphere:Sphere = new Sphere(new Vector3D(), 1);
            sphere.radius = NaN;
            assertThrows(RangeError, /middle and half of its length must .* finite/, _queries.overlapping, sphere);
            var box:Box = new Box(new Vector3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), 1, 1, 1);
            box.center.x = Infinity;
            assertThrows(RangeError, /middle and half of its length must .* finite/, _queries.overlapping, box);
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                _queries.update(_agents);
                return true;
            };
            assertThrows(IllegalOperationError, /accepts/, _queries.near, _agents[0], 3, filter);
            for each (var change:Function in [tellOfAMove, moveUntilTouch, slide])
            {
                var changing:AgentFilter = new AgentFilter();
                changing.accepts = function(agent:Agent):Boolean
                {
                    change();
                    return true;
                };
                assertThrows(IllegalOperationError, /must not be called from a filter's accepts/, _queries.near, _agents[0], Infinity, changing);
                assertThrows(IllegalOperationError, /must not be called from a filter's accepts/, _queries.nearest, _agents[0], Infinity, changing);
                assertThrows(IllegalOperationError, /must not be called from a filter's accepts/, _queries.castAll, new Vector3D(-60, 0, 0.5), new Vector3D(1, 0, 0),
                        Infinity, changing);
                change();
            }
            _agents[5].shape = "cube";
            assertEquals(before, answers());
            _queries.update(_agents);
        }

        [Test]
        public function followsItsCollision():void
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            var queries:AgentQueries = new AgentQueries(collision);
            queries.update(_agents);
            var bins:String = touchesOf(queries);
            collision.collisionSystem = new TightestFitCollider(_greatLand);
            assertEquals("not before an update", bins, touchesOf(queries));
            queries.update(_agents);
            assertEquals(touchesOf(_queries), touchesOf(queries));
            assertTrue("they differ", bins != touchesOf(queries));
            collision.collisionSystem = new OwnVectorSystem(new <Agent>[]);
            assertThrows(ArgumentError, /one of the engine's collision systems/, queries.update, _agents);
            assertEquals(touchesOf(_queries), touchesOf(queries));
            for each (var source:Object in [collision, null, "bins", new OwnVectorSystem(new <Agent>[])])
            {
                assertThrows(ArgumentError, /one of the engine's collision systems/, newQueries, source);
            }

            function newQueries(source:Object):void
            {
                new AgentQueries(source);
            }
        }

        [Test]
        public function loadingAgentsHavePlacesAlone():void
        {
            var loader:ModelLoader = new ModelLoader(_greatLand);
            loader.load("late", "late.obj");
            var late:Agent = new Agent("late");
            var cube:Agent = new Agent("cube");
            _queries.update(new <Agent>[late, cube]);
            assertStrictlyEquals(late, _queries.nearest(cube));
            assertEquals(0, _queries.touching(cube).length);
            assertEquals(0, _queries.touching(late).length);
            assertEquals(1, _queries.overlapping(new Sphere(new Vector3D(), 1)).length);
            loader.cancel("late");
            _greatLand.addModel(new Model("late", BuiltInModel.cube().vertices, BuiltInModel.cube().triangles));
            _queries.moved(late);
            assertEquals(1, _queries.touching(cube).length);
        }

        private function tellOfAMove():void
        {
            _queries.moved(_agents[1]);
        }

        private function moveUntilTouch():void
        {
            _queries.moveUntilTouch(_agents[1], 1, 0, 0);
        }

        private function slide():void
        {
            _queries.slide(_agents[1], 1, 0, 0);
        }

        [Test]
        public function thousandsAtOnePlaceAreNoTrouble():void
        {
            var asked:int = 0;
            var crowd:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 5000; i++)
            {
                var agent:Agent = new Agent("cube", i < 4990 ? "many" : "few");
                agent.moveTo(7, 7, 7);
                crowd.push(agent);
            }
            var alone:Agent = new Agent("cube");
            crowd.push(alone);
            _queries.update(crowd);
            var filter:AgentFilter = AgentFilter.ofBreeds("few");
            for (i = 0; i < 300; i++)
            {
                assertEquals(4999, _queries.countNear(crowd[i], 0));
                assertEquals(4999, _queries.countNear(crowd[i], 1));
                assertStrictlyEquals(crowd[0], _queries.nearest(alone));
                assertEquals(0, _queries.near(alone, 5).length);
            }
            assertEquals(10, _queries.near(crowd[0], 1, filter).length);
            filter.breeds = null;
            filter.accepts = function(agent:Agent):Boolean
            {
                asked++;
                return agent == alone;
            };
            assertStrictlyEquals(alone, _queries.nearest(crowd[17], Infinity, filter));
            assertEquals("each is asked once", 5000, asked);
            asked = 0;
            assertNull(_queries.nearest(crowd[17], 3, filter));
            assertEquals(4999, asked);
            asked = 0;
            assertTrue(_queries.touchesAny(crowd[17], new AgentFilter()));
            filter.accepts = function(agent:Agent):Boolean
            {
                asked++;
                return agent == crowd[5] || agent == crowd[6];
            };
            assertTrue(_queries.touchesAny(crowd[17], filter));
            assertEquals("no more are asked", 6, asked);
            asked = 0;
            assertEquals(2, _queries.nearestOf(crowd[17], 2, 3, filter).length);
            assertEquals("no more are asked", 7, asked);
        }

        // What accepts asks may have a filter that asks too: of rays, though the first question is of places.
        [Test]
        public function filtersAskOfEachOther():void
        {
            var inner:AgentFilter = new AgentFilter();
            inner.accepts = function(agent:Agent):Boolean
            {
                return _queries.nearestOf(agent, 3).length == 3;
            };
            var outer:AgentFilter = new AgentFilter();
            outer.accepts = function(agent:Agent):Boolean
            {
                var from:Vector3D = new Vector3D(agent.x, agent.y, agent.z + 20);
                return _queries.cast(from, new Vector3D(0, 0, -1), Infinity, inner) != null && _queries.castAll(from, new Vector3D(0, 0, -1), 50, inner).length > 0;
            };
            var near:String = LoopedQuestions.numbers(_queries.near(_agents[0], 3));
            assertTrue("some are near", near.length > 10);
            assertEquals(near, LoopedQuestions.numbers(_queries.near(_agents[0], 3, outer)));
        }

        [Test]
        public function filtersAskWhatTouches():void
        {
            var inner:AgentFilter = new AgentFilter();
            inner.accepts = function(agent:Agent):Boolean
            {
                return _queries.touching(agent).length > 2;
            };
            var outer:AgentFilter = new AgentFilter();
            outer.accepts = function(agent:Agent):Boolean
            {
                return _queries.touchesAny(agent, inner);
            };
            var asked:int = 0;
            var left:int = 0;
            for each (var agent:Agent in _agents)
            {
                var expected:Vector.<Agent> = _queries.touching(agent).filter(function(other:Agent, index:int, all:Vector.<Agent>):Boolean
                    {
                        return _queries.touching(other).some(function(third:Agent, at:int, them:Vector.<Agent>):Boolean
                            {
                                return _queries.touching(third).length > 2;
                            });
                    });
                assertEquals(LoopedQuestions.numbers(expected), LoopedQuestions.numbers(_queries.touching(agent, outer)));
                asked += _queries.touching(agent).length;
                left += expected.length;
            }
            assertTrue(left + " of " + asked, left > 10 && left < asked - 10);
        }

        [Test]
        public function anEmptyListHasNothing():void
        {
            _queries.update(new Vector.<Agent>());
            var point:Vector3D = new Vector3D(0, 0, 0.5);
            assertNull(_queries.nearestToPoint(point));
            assertEquals(0, _queries.nearPoint(point, Infinity).length + _queries.countNearPoint(point, Infinity));
            assertEquals(0, _queries.overlapping(new Sphere(point, 100)).length + _queries.castAll(point, new Vector3D(1, 0, 0)).length);
            assertNull(_queries.cast(point, new Vector3D(1, 0, 0)));
            assertNull(_queries.castShape(new Sphere(point, 100), 1, 0, 0));
            _queries.update(_agents);
        }

        [Test]
        public function nobodyMayBeLeftOut():void
        {
            var filter:AgentFilter = new AgentFilter();
            filter.except = new <Agent>[null, _agents[3], null];
            var plain:AgentFilter = new AgentFilter();
            plain.except = new <Agent>[_agents[3]];
            assertEquals(LoopedQuestions.numbers(_queries.near(_agents[0], Infinity, plain)), LoopedQuestions.numbers(_queries.near(_agents[0], Infinity, filter)));
            assertEquals(_agents.length - 2, _queries.countNear(_agents[0], Infinity, filter));
        }

        // The list of a question is written when the question is answered, not while accepts is called.
        [Test]
        public function filtersMayUseTheSameList():void
        {
            var list:Vector.<Agent> = new Vector.<Agent>();
            var same:AgentFilter = new AgentFilter();
            same.accepts = function(agent:Agent):Boolean
            {
                return _queries.near(agent, 5, null, list).length > 0;
            };
            var near:String = LoopedQuestions.numbers(_queries.nearestOf(_agents[0], 9));
            assertEquals(near, LoopedQuestions.numbers(_queries.nearestOf(_agents[0], 9, Infinity, same, list)));
            var throwing:AgentFilter = new AgentFilter();
            var left:int = 6;
            throwing.accepts = function(agent:Agent):Boolean
            {
                left--;
                if (left == 0)
                {
                    throw new IllegalOperationError("in accepts");
                }
                return true;
            };
            assertThrows(IllegalOperationError, /in accepts/, _queries.nearestOf, _agents[1], 9, Infinity, throwing, list);
            assertEquals("the list is unchanged", near, LoopedQuestions.numbers(list));
            assertEquals("questions go on", near, LoopedQuestions.numbers(_queries.nearestOf(_agents[0], 9)));
        }

        [Test]
        public function nobodyInTheListMovesInAFilter():void
        {
            var stranger:Agent = new Agent("cube");
            stranger.moveTo(0, 0, 90);
            _queries.terrain = new Terrain(41, 41, 1, -20, -20);
            _queries.update(_agents);
            var mover:Agent = null;
            for each (var move:Function in [moveIt, slideIt, walkIt])
            {
                var moving:AgentFilter = new AgentFilter();
                moving.accepts = function(agent:Agent):Boolean
                {
                    move();
                    return true;
                };
                for each (mover in [_agents[0], _agents[1], _agents[299]])
                {
                    var before:Number = mover.x;
                    assertThrows(IllegalOperationError, /must not be called from a filter's accepts/, _queries.nearest, stranger, Infinity, moving);
                    assertEquals(before, mover.x);
                }
                mover = _queries.terrain.agent;
                assertThrows(ArgumentError, /has no place, and does not move/, _queries.nearest, stranger, Infinity, moving);
                mover = stranger;
                _queries.nearest(_agents[0], Infinity, moving);
            }
            assertClose(3, stranger.x, 1e-9);

            function moveIt():void
            {
                _queries.moveUntilTouch(mover, 1, 0, 0);
            }

            function slideIt():void
            {
                _queries.slide(mover, 1, 0, 0);
            }

            function walkIt():void
            {
                _queries.walk(mover, 1, 0);
            }
        }

        private function answers():String
        {
            var answers:Array = [];
            for (var i:int = 0; i < _agents.length; i += 7)
            {
                answers.push(LoopedQuestions.numbers(_queries.nearPoint(new Vector3D(i % 9, i % 5, 1), 3)),
                        LoopedQuestions.numbers(_queries.overlapping(new Sphere(new Vector3D(i % 9, i % 5, 1), 1))));
            }
            return answers.join(";");
        }

        private function touchesOf(queries:AgentQueries):String
        {
            var touches:Array = [];
            for each (var agent:Agent in _agents)
            {
                touches.push(LoopedQuestions.numbers(queries.touching(agent)));
            }
            return touches.join(";");
        }
    }
}

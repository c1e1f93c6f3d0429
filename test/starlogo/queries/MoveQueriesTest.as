package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    /** How far agents go until they touch, and what stops nothing. test/fuzz has random motions. */
    public class MoveQueriesTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "plank", "hollow", "apart"];

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(2203);
        private var _wrong:Complaints = new Complaints();

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(SolidModels.all(), BuiltInModel.cylinder(), SolidModels.plank());
        }

        [Test]
        public function aTouchAtTheVeryEndOfAWayHasANormal():void
        {
            var ends:int = 0;
            for each (var name:String in EachCollider.NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                for each (var shape:String in ["sphere", "cube", "cylinder"])
                {
                    var agents:Vector.<Agent> = new <Agent>[new Agent(shape), new Agent(shape)];
                    agents[1].x = 3;
                    queries.update(agents);
                    var free:Number = 4 * queries.moveUntilTouch(agents[0], 4, 0, 0);
                    for (var i:int = -40; i <= 40; i++)
                    {
                        var contact:Contact = new Contact();
                        agents[0].moveTo(0, 0, 0);
                        var part:Number = queries.moveUntilTouch(agents[0], free * (1 + i * 1e-10), 0, 0, null, contact);
                        if (part < 1)
                        {
                            ends++;
                            assertTrue(name + ", " + shape + ", normal " + contact.normal, contact.normal.x < -0.5);
                        }
                        agents[0].moveTo(0, 0, 0);
                        queries.slide(agents[0], free * (1 + i * 1e-10), 0, 0);
                        assertEquals(name + ", " + shape, free, Math.round(agents[0].x * 1e6) == Math.round(free * 1e6) ? free : agents[0].x);
                    }
                }
            }
            assertTrue(ends + " ended in a touch", ends > 100);
        }

        [Test]
        public function noNumberOfSmallMotionsLeadsDeeper():void
        {
            for each (var start:Number in [5e-10, 5e-9])
            {
                for (var others:int = 1; others <= 2; others++)
                {
                    var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere"), new Agent("sphere")];
                    agents[0].moveTo(0, 0, 1 - start);
                    agents[2].moveTo(0.9, 0, 0.4);
                    agents.length = 1 + others;
                    var queries:AgentQueries = new AgentQueries(new BinCollider());
                    queries.update(agents);
                    for (var i:int = 0; i < 2000; i++)
                    {
                        queries.moveUntilTouch(agents[0], 0, 0, -5e-11);
                    }
                    assertTrue(others + ", " + start + ": " + (1 - agents[0].z), 1 - agents[0].z < start + 1e-9);
                }
            }
        }

        /**
         * A cube passes a sphere that is in its way by about as much as its core is smaller, sometimes with a wall near the touch. The core meets the sphere
         * at a grazing angle, where the plane of the contact is far before the sphere.
         */
        [Test]
        public function whatIsGrazedStopsWhereItIsTouched():void
        {
            var bySphere:int = 0;
            var byWall:int = 0;
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(sGreatLand));
            for (var i:int = Effort.choose(500, 5000); i > 0; i--)
            {
                var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, _random.between(0.8, 1.5), 0), agentAt("sphere", 0, 0, 0), agentAt("cube", 0.6, 0, 0)];
                // if the sphere is in the way of the core by less than 1e-12 or so, rounding decides whether the core meets it
                var inWay:Number = 4.2e-10 * (1 + _random.pick([-1, 1]) * _random.logBetween(3e-3, 1));
                // where the cube touches each of the two
                var atSphere:Number = 0.5 + Math.sqrt(inWay * (1 - inWay));
                var atWall:Number = 0.5 + _random.pick([-1, 1]) * _random.logBetween(1e-5, 1e-3);
                var cube:Agent = agents[0];
                agents[1].x = inWay - 1;
                agents[2].y = atWall - 1;
                queries.update(agents);
                var motion:Number = -_random.between(2, 3);
                var y:Number = cube.y;
                var hit:ShapeHit = queries.castAgent(cube, 0, motion, 0);
                var free:Number = queries.moveUntilTouch(cube, 0, motion, 0);
                var isWall:Boolean = hit.agent == agents[2];
                byWall += int(isWall);
                bySphere += int(!isWall);
                var text:String = [inWay, atWall, y, motion] + ": ";
                // if the core hardly meets the sphere, the cube may go on to where it is nearest to the sphere's middle
                var last:Number = isWall ? atWall : 0.5 - 1e-6;
                _wrong.addIf(cube.y < last - 1e-7 || cube.y > (isWall ? atWall : atSphere) + 1e-7, "no touch", text + cube.y);
                _wrong.addIf(Math.abs(y + free * motion - cube.y) > 1e-12, "goes farther than it says", text + (y + free * motion - cube.y));
                _wrong.addIf(Math.abs(hit.time - free) > 1e-7, "a cast's time", text + (hit.time - free));
                _wrong.addIf(cube.y < atWall - 1e-12, "in the wall", text + (atWall - cube.y));
            }
            _wrong.assertNone();
            assertTrue(bySphere + " by the sphere, " + byWall + " by the wall", bySphere > 50 && byWall > 50);
        }

        [Test]
        public function motionsOfAllSmallnesses():void
        {
            var stopped:int = 0;
            var free:int = 0;
            for each (var name:String in EachCollider.NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                for (var i:int = Effort.choose(200, 5000); i > 0; i--)
                {
                    var agents:Vector.<Agent> = RandomWorlds.mixed(6, SHAPES, 1.5, _random);
                    var mover:Agent = agents[0];
                    if (_random.chance())
                    {
                        mover.moveTo(0, 0, 0);
                    }
                    queries.update(agents);
                    var isFree:Boolean = !queries.touchesAny(mover);
                    var contact:Contact = new Contact();
                    var smallness:Number = Math.pow(10, -_random.between(0, 320));
                    var dx:Number = _random.between(-1, 1) * smallness;
                    var dy:Number = _random.between(-1, 1) * smallness;
                    var dz:Number = _random.chance() ? 0 : _random.between(-1, 1) * smallness;
                    var x:Number = mover.x;
                    var slides:Boolean = _random.chance();
                    var part:Number = slides ? queries.slide(mover, dx, dy, dz) : queries.moveUntilTouch(mover, dx, dy, dz, null, contact);
                    _wrong.addIf(!(part >= 0 && part <= 1) || !(contact.time >= 0 && contact.time <= 1),
                            name + ": no part", part + " of " + [dx, dy, dz] + " at " + contact.time);
                    // along a plane it may go farther along x, but never farther than the whole way
                    _wrong.addIf(!(Math.abs(mover.x - x) <= 2 * smallness + 1e-8), name + ": elsewhere", mover.x + " from " + x + " by " + dx);
                    _wrong.addIf(part == 1 && isFree && mover.x != x + dx, name + ": free, and not there", mover.x + " from " + x + " by " + dx);
                    part == 1 ? free++ : stopped++;
                }
            }
            _wrong.assertNone();
            assertTrue(stopped + " stopped, " + free + " free", stopped > 60 && free > 300);
        }

        // A sweep touches across a wider gap than a body that stands, the wider the longer the way is.
        [Test]
        public function aPointLeavesWhatItIsJustBeforeOnAWayOfAnyLength():void
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make("tightest fits", landOf(new Model("point", new <Number>[0, 0, 0], null, Model.AS_GIVEN), BuiltInModel.cube())));
            var point:Agent = agentAt("point", 0, 0, 0);
            var cube:Agent = agentAt("cube", 0, 0, 0);
            var ground:Terrain = new Terrain(3, 3, 1, -1, -1);
            for each (var isOnGround:Boolean in [true, false])
            {
                queries.terrain = isOnGround ? ground : null;
                queries.update(isOnGround ? new <Agent>[point] : new <Agent>[point, cube]);
                for (var gap:Number = 1e-16; gap < 1e-9; gap *= 1.5)
                {
                    for (var length:Number = 1e-3; length < 1e6; length *= 10)
                    {
                        point.moveTo(0.3, 0.2, isOnGround ? gap : 1 + gap);
                        queries.refresh(point);
                        _wrong.addIf(queries.castAgent(point, 2 * length, length, length) != null, "a cast", gap + " before, " + length);
                        _wrong.addIf(queries.moveUntilTouch(point, 2 * length, length, length) < 1, "a motion", gap + " before, " + length);
                    }
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function outOfADeepOverlapTheWayIsFree():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, sGreatLand));
                var mover:Agent = agentAt("cube", 0.7, 0.02, 0);
                queries.update(new <Agent>[mover, agentAt("cube", 0, 0, 0)]);
                var contact:Contact = new Contact();
                assertEquals(name, 0, queries.moveUntilTouch(mover, -0.1, 0, 0, null, contact));
                assertNear(name, mover, 0.7, 0.02, 0);
                assertTrue(name, contact.normal.x > 0.9 && contact.time == 0 && contact.depth > 0.2);
                assertEquals(name, 1, queries.moveUntilTouch(mover, 0.1, 0, 0));
                assertNear(name, mover, 0.8, 0.02, 0);
                queries.slide(mover, -0.1, 0.2, 0);
                assertTrue(name, mover.y > 0.2 && mover.x > 0.79);
                assertEquals(name, 1, queries.moveUntilTouch(mover, 3, 0, 0));
                assertTrue(name, queries.moveUntilTouch(mover, -5, 0, 0) < 0.9);
            }
        }

        [Test]
        public function motionsMustBeNumbersAndNoneIsNone():void
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make("triangles", sGreatLand));
            var mover:Agent = agentAt("cube", 0, 0, 0);
            queries.update(new <Agent>[agentAt("cube", 0.5, 0, 0), agentAt("cube", 3, 0, 0)]);
            assertThrows(RangeError, /NaN/, queries.moveUntilTouch, mover, NaN, 0, 0);
            assertThrows(RangeError, /Infinity/, queries.slide, mover, 0, 0, Infinity);
            assertThrows(ArgumentError, /null/, queries.slide, null, 0, 0, 1);
            var revision:Number = mover.x;
            assertEquals(1, queries.moveUntilTouch(mover, 0, 0, 0));
            assertEquals(1, queries.slide(mover, 0, 0, 0));
            assertEquals(revision, mover.x);
        }

        /** As after every motion, questions see the agent where it is, also if the game has moved it before. */
        [Test]
        public function aMotionWithoutAWayReadsTheAgentAgain():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider());
            var mover:Agent = new Agent("cube");
            queries.update(new <Agent>[mover]);
            for each (var motion:Function in [queries.moveUntilTouch, queries.slide])
            {
                mover.x += 50;
                motion(mover, 0, 0, 0);
                assertEquals(mover, queries.nearestToPoint(new Vector3D(mover.x, 0, 0), 1));
            }
        }

        [Test]
        public function filtersLetThrough():void
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make("hierarchies", sGreatLand));
            var mover:Agent = agentAt("cube", 0, 0, 0);
            var ghost:Agent = agentAt("cube", 2, 0, 0);
            ghost.breed = "ghosts";
            queries.update(new <Agent>[mover, ghost, agentAt("cube", 4, 0, 0)]);
            var filter:AgentFilter = new AgentFilter();
            filter.exceptBreeds = new <String>["ghosts"];
            assertTrue(Math.abs(queries.moveUntilTouch(mover, 8, 0, 0, filter) - 3 / 8) < 1e-9);
            mover.moveTo(0, 0, 0);
            filter.accepts = function(agent:Agent):Boolean
            {
                // a question of its own
                queries.moveUntilTouch(agentAt("cube", 0, 50, 0), 1, 0, 0);
                return agent.x < 0;
            };
            assertEquals(1, queries.moveUntilTouch(mover, 8, 0, 0, filter));
            assertEquals(1, queries.countNear(agentAt("cube", 8, 0, 0), 0.1));
        }

        [Test]
        public function anAgentStaysIfAcceptsRemovesItsModel():void
        {
            for each (var name:String in ["moveUntilTouch", "slide", "walk"])
            {
                var greatLand:GreatLand = landOf(BuiltInModel.cube(), BuiltInModel.sphere());
                var queries:AgentQueries = new AgentQueries(new TightestFitCollider(greatLand));
                var mover:Agent = agentAt("cube", 0, 0, 0);
                queries.update(new <Agent>[mover, agentAt("sphere", 5, 0, 0)]);
                var options:WalkOptions = new WalkOptions();
                var filter:AgentFilter = options.filter = new AgentFilter();
                filter.accepts = function(agent:Agent):Boolean
                {
                    greatLand.removeModel("cube");
                    return true;
                };
                if (name == "walk")
                {
                    assertThrows(ArgumentError, /cube/, queries.walk, mover, 9, 0, options);
                }
                else
                {
                    assertThrows(ArgumentError, /cube/, queries[name], mover, 9, 0, 0, filter);
                }
                assertEquals(name, 0, mover.x);
            }
        }

        private static function assertNear(message:String, agent:Agent, x:Number, y:Number, z:Number):void
        {
            var distance:Number = Math.abs(agent.x - x) + Math.abs(agent.y - y) + Math.abs(agent.z - z);
            assertTrue(message + ": " + agent.x + ", " + agent.y + ", " + agent.z, distance < 3e-9);
        }
    }
}

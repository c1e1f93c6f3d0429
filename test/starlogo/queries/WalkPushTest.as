package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    /** Agents that are pushed out of what they overlap, and carried by what they stand on. */
    public class WalkPushTest
    {
        // A BinCollider has no flat floors.
        private static const NAMES:Array = ["tightest fits", "hierarchies", "triangles", "combinations", "combinations, exact"];
        private static const NEAR:Number = 1e-6;

        private var _greatLand:GreatLand = landOf(BuiltInModel.cube(), BuiltInModel.cylinder());

        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _walker:Agent;
        private var _floor:Agent;
        private var _wall:Agent;
        private var _agents:Vector.<Agent>;
        private var _queries:AgentQueries;

        [Test]
        public function aTurnBesideAWallPushes():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(0.7501, 0, 0);
                _queries.update(_agents);
                var pushed:Number = 0;
                for (var i:int = 0; i < 9; i++)
                {
                    _walker.heading += 10;
                    _queries.walk(_walker, 0.05, 0, _options, _footing);
                    pushed += _footing.pushed;
                    assertTrue(name + ": " + i + ", " + _footing.pushed, _footing.stands && _footing.pushed < 0.05 && !_queries.touchesAny(_walker));
                }
                assertTrue(name + ": " + pushed, Math.abs(pushed - (0.25 * Math.SQRT2 - 0.25)) < 0.01);
                assertTrue(name + ": back at the wall " + _walker.x, Math.abs(_walker.x - 0.0001) < NEAR && Math.abs(_walker.z) < NEAR);
            }
        }

        // Two balls hold the walker, and the pushes do not lead out of both.
        [Test]
        public function inTheAirWhatOverlapsLeadsNeitherUpNorDown():void
        {
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(landOf(BuiltInModel.sphere())));
            var walker:Agent = agentAt("sphere", 0, 0, 5);
            queries.update(new <Agent>[walker, agentAt("sphere", 0.9, 0, 5.1), agentAt("sphere", -0.3, 0, 5.1)]);
            _options.fall = 0;
            queries.walk(walker, -0.7, 0, _options, _footing);
            assertTrue(walker.z + " after " + _footing.pushed, !_footing.stands && 5 - walker.z <= _footing.pushed);
        }

        // Three blocks hold the walker. Between upright walls it would stay for ever.
        [Test]
        public function inTheAirWhatWedgesMayLeadUp():void
        {
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(landOf(BuiltInModel.sphere(), BuiltInModel.cube())));
            var walker:Agent = agentAt("sphere", 0, 0, 5);
            var blocks:Vector.<Agent> = new <Agent>[agentAt("cube", -0.7, -0.2, 5.2), agentAt("cube", 0.6, -0.9, 4.8), agentAt("cube", 0.6, 0.6, 4.4)];
            blocks[0].heading = -15;
            blocks[1].heading = -30;
            blocks[1].pitch = 30;
            blocks[2].heading = 30;
            blocks[2].pitch = 15;
            blocks[2].size = 2;
            queries.update(new <Agent>[walker].concat(blocks));
            _options.fall = 0;
            for (var i:int = 0; i < 20 && queries.touchesAny(walker); i++)
            {
                var low:Number = walker.z;
                queries.walk(walker, -0.3, 0.4, _options, _footing);
                assertTrue([i, low, walker.z, _footing.pushed].join(), low - walker.z <= _footing.pushed);
            }
            assertTrue(walker.x + ", " + walker.z, !queries.touchesAny(walker) && walker.z > 5);
        }

        [Test]
        public function whatGrowsAndWhatComesPushes():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(0.8, 0, 0);
                _queries.update(_agents);
                _walker.size = 0.8;
                _queries.walk(_walker, 0, 0, _options, _footing);
                assertTrue(name + ": grown " + _footing.pushed, Math.abs(_footing.pushed - 0.1) < NEAR && Math.abs(_walker.x + 0.1) < NEAR);
                for (var i:int = 1; i <= 8; i++)
                {
                    _wall.x -= 0.1;
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertTrue(name + ": pushed " + _footing.pushed, Math.abs(_footing.pushed - 0.1) < NEAR && _footing.stands && _footing.part == 1);
                    assertTrue(name + ": at " + _walker.x, Math.abs(_walker.x - _wall.x + 0.9) < NEAR && Math.abs(_walker.z) < NEAR);
                }
            }
        }

        [Test]
        public function aPushLeadsAClearanceOut():void
        {
            begin("tightest fits");
            _wall.moveTo(0.65, 0, 0);
            _queries.update(_agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
            var clearance:Number = _footing.pushed - 0.1;
            assertTrue(String(clearance), clearance > 5e-11 && clearance < 1e-8);
        }

        [Test]
        public function aFilterThatAsksForAPushItselfChangesNone():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(0.65, 0, 0);
                _queries.update(_agents);
                _options.filter = new AgentFilter();
                _options.filter.accepts = function(agent:Agent):Boolean
                {
                    return _queries.walk(agentAt("cube", 1.2, 0, 0), 0, 0).pushed > 0.1;
                };
                _queries.walk(_walker, 0, 0, _options, _footing);
                assertTrue(name + ": pushed " + _footing.pushed, Math.abs(_footing.pushed - 0.1) < NEAR && Math.abs(_walker.x + 0.1) < NEAR);
                _options.filter = null;
            }
        }

        [Test]
        public function whatIsSqueezedGoesThroughNothing():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                var other:Agent = agentAt("cube", -0.8, 0, 0);
                _agents.push(other);
                for (var i:int = 0; i <= 14; i++)
                {
                    _wall.moveTo(1.3 - 0.05 * i, 0, 0);
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertTrue(name + ": " + i + " at " + _walker.x, _walker.x > -0.05 - NEAR && _walker.x < 0.55);
                    assertTrue(name + ": " + i + ", pushed " + _footing.pushed, _footing.pushed < 0.36);
                }
                // it comes free sideways, and when there is room again
                assertTrue(name, _queries.touchesAny(_walker));
                _wall.moveTo(1.5, 0, 0);
                _queries.update(_agents);
                _queries.walk(_walker, 0.1, 0, _options, _footing);
                assertTrue(name + ": free at " + _walker.x, !_queries.touchesAny(_walker) && _footing.part > 0.99);
            }
        }

        [Test]
        public function theGroundPushes():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var isBlocky:Boolean in [false, true])
                {
                    begin(name);
                    var terrain:Terrain = new Terrain(21, 21, 1, -10, -10);
                    terrain.isBlocky = isBlocky;
                    _queries.terrain = terrain;
                    _queries.update(new <Agent>[_walker]);
                    _walker.moveTo(0, 0, 0.01);
                    for (var i:int = 0; i < 5; i++)
                    {
                        terrain.raiseMound(0, 0, 16, 0.1);
                        _queries.walk(_walker, 0, 0, _options, _footing);
                        var over:Number = _walker.z - terrain.heightAt(_walker.x, _walker.y);
                        assertTrue([name, isBlocky, i, over, _footing.pushed].join(), _footing.stands && over > -NEAR && over < 0.02 && !_queries.touchesAny(_walker));
                        assertTrue([name, _footing.pushed].join(), i == 0 || Math.abs(_footing.pushed - 0.1) < 0.01);
                    }
                }
            }
        }

        [Test]
        public function aPlatformCarries():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _walker.moveTo(0.5, 0, 0);
                _queries.update(_agents);
                _queries.walk(_walker, 0, 0, _options, _footing);
                for (var i:int = 1; i <= 10; i++)
                {
                    _floor.moveTo(0.1 * i, -0.2 * i, -4 + 0.05 * i);
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0.01, _options, _footing);
                    assertTrue(name + ": moved " + [i, _walker.x, _walker.y, _walker.z], Math.abs(_walker.x - 0.5 - 0.1 * i) < NEAR
                            && Math.abs(_walker.y + 0.19 * i) < NEAR && Math.abs(_walker.z - 0.05 * i) < NEAR && _footing.pushed == 0);
                    assertStrictlyEquals(_floor, _footing.on);
                }
                // half of a turn about the middle
                var x:Number = _walker.x - _floor.x;
                var y:Number = _walker.y - _floor.y;
                for (i = 0; i < 18; i++)
                {
                    _floor.heading += 10;
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                }
                assertTrue(name + ": turned " + [_walker.x, _walker.y], Math.abs(_walker.x - _floor.x + x) < NEAR && Math.abs(_walker.y - _floor.y + y) < NEAR);
                assertTrue(name + ": heading " + _walker.heading, Math.abs(_walker.heading - 180) < NEAR && Math.abs(_walker.z - 0.5) < NEAR);
            }
        }

        // A small walker keeps its place on a platform that tilts, turns, grows and moves. What tilts may push it by a part of its own size.
        [Test]
        public function aPlatformThatTiltsCarries():void
        {
            var random:SeededRandom = new SeededRandom(11);
            _options.fall = _options.snap = _options.stepHeight = 0;
            for each (var name:String in NAMES)
            {
                begin(name);
                _walker.size = 0.02;
                for (var i:int = 0; i < 40; i++)
                {
                    _floor.heading = _floor.pitch = _floor.roll = 0;
                    _floor.size = 4;
                    _floor.moveTo(0, 0, -4);
                    _walker.moveTo(random.between(-1.5, 1.5), random.between(-1.5, 1.5), 0);
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertStrictlyEquals(_floor, _footing.on);
                    for (var j:int = 0; j < 2; j++)
                    {
                        var before:Matrix3D = _floor.getMatrix();
                        before.invert();
                        var inFloor:Vector3D = before.transformVector(new Vector3D(_walker.x, _walker.y, _walker.z));
                        var from:Vector.<Number> = _floor.getQuaternion();
                        var heading:Number = _walker.heading;
                        _floor.heading += random.between(-20, 20);
                        _floor.pitch += random.between(-4, 4);
                        _floor.roll += random.between(-4, 4);
                        _floor.size *= random.between(0.95, 1.05);
                        _floor.moveTo(random.between(-1, 1), random.between(-1, 1), -4 + random.between(-0.2, 0.2));
                        _queries.update(_agents);
                        _queries.walk(_walker, 0, 0, _options, _footing);
                        var carried:Vector3D = _floor.getMatrix().transformVector(inFloor);
                        var distance:Number = Vector3D.distance(carried, new Vector3D(_walker.x, _walker.y, _walker.z));
                        assertTrue([name, i, j, distance].join(), distance < 0.5 * _walker.size);
                        var turned:Number = _walker.heading - heading - turnAboutZ(from, _floor.getQuaternion());
                        assertTrue([name, i, j, "heading", _walker.heading, turned].join(), Math.abs(turned - 360 * Math.round(turned / 360)) < NEAR);
                    }
                }
            }
        }

        // A deck that is tilted in both headings turns about the z axis alone, and so does who stands on it.
        [Test]
        public function aTiltedDeckTurnsWhoStandsOnIt():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.box(10, 10, 1, "deck"), BuiltInModel.capsule(0.3, 1.8, "hero"));
            for each (var name:String in NAMES)
            {
                var deck:Agent = agentAt("deck", 0, 0, 0, "decks");
                deck.pitch = 25;
                deck.heading = 40;
                deck.hierarchical = true;
                var hero:Agent = agentAt("hero", 0, 0, 1.3, "heroes");
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, greatLand));
                for (var i:int = -5; i <= 3; i++)
                {
                    // it falls onto the deck first
                    deck.heading += i > 0 ? 10 : 0;
                    queries.update(new <Agent>[deck, hero]);
                    queries.walk(hero, 0, 0, null, _footing);
                    var expected:Number = i > 0 ? 10 * i : 0;
                    assertTrue([name, i, hero.heading].join(), Math.abs(hero.heading - expected) < NEAR);
                }
                assertStrictlyEquals(name, deck, _footing.on);
            }
        }

        // The turn about the z axis, in degrees, that is in the rotation from one quaternion to another: the twist of its swing and twist.
        private static function turnAboutZ(from:Vector.<Number>, to:Vector.<Number>):Number
        {
            var z:Number = to[2] * from[3] - to[3] * from[2] + to[1] * from[0] - to[0] * from[1];
            var w:Number = to[3] * from[3] + to[0] * from[0] + to[1] * from[1] + to[2] * from[2];
            return 2 * Math.atan2(z, w) * 180 / Math.PI;
        }

        [Test]
        public function whatIsCarriedSlidesAlongAWall():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(1, 0, 0);
                for (var i:int = 0; i < 10; i++)
                {
                    _floor.moveTo(0.05 * i, 0.05 * i, -4);
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertTrue(name + ": " + [i, _walker.x, _walker.y], Math.abs(_walker.x - Math.min(0.25, 0.05 * i)) < NEAR
                            && Math.abs(_walker.y - 0.05 * i) < NEAR && _footing.stands);
                }
            }
        }

        // The walk itself is shorter than the way to the wall.
        [Test]
        public function whatIsCarriedFarStopsAtAWall():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(1.5, 0, 0);
                carryOnce(2);
                assertTrue(name + ": " + _walker.x, Math.abs(_walker.x - 0.75) < NEAR && _footing.stands);
            }
        }

        // A box that a platform turns beside a wall gets pushed away from the wall in the same walk.
        [Test]
        public function aPlatformTurnsNothingIntoAWall():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(0.7501, 0, 0);
                var pushed:Number = 0;
                for (var i:int = 1; i <= 9; i++)
                {
                    _floor.heading += 10;
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    pushed += _footing.pushed;
                    assertTrue(name + ": turned " + [i, _walker.x, _walker.heading], _footing.stands && !_queries.touchesAny(_walker)
                            && Math.abs(_walker.heading - 10 * i) < NEAR);
                }
                assertTrue(name + ": " + pushed, Math.abs(pushed - (0.25 * Math.SQRT2 - 0.25)) < 0.01);
            }
        }

        // A platform carries a box under a slope. The slope must not lead the box down into the platform.
        [Test]
        public function aSlopeLeadsNothingIntoItsPlatform():void
        {
            for each (var name:String in NAMES)
            {
                begin(name);
                _wall.moveTo(1.2, 0, 0);
                _wall.pitch = -30;
                for (var i:int = 1; i <= 6; i++)
                {
                    _floor.moveTo(0.2 * i, 0, -4);
                    _queries.update(_agents);
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertTrue(name + ": " + [i, _walker.x, _walker.z, _footing.pushed], _footing.stands && _footing.pushed == 0 && !_queries.touchesAny(_walker));
                }
                assertTrue(name + ": at the slope " + _walker.x, _walker.x > 0.05 && _walker.x < 0.15);
            }
        }

        [Test]
        public function whatHasLeftIsNotCarried():void
        {
            begin("tightest fits");
            _options.carried = false;
            carryOnce(1);
            assertEquals(0, _walker.x);
            _options.carried = true;
            carryOnce(2);
            assertTrue(String(_walker.x), Math.abs(_walker.x - 1) < NEAR);
            // the game has computed its place back and forth
            _walker.moveTo(_walker.x + 2e-15, _walker.y, _walker.z);
            carryOnce(1.5);
            assertTrue(String(_walker.x), Math.abs(_walker.x - 0.5) < NEAR);
            // the game has moved it, or the platform has jumped
            _walker.moveTo(1, 0.5, 0);
            carryOnce(1);
            assertEquals(1, _walker.x);
            _floor.jumpTo(0, 0, -4);
            _queries.update(_agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertEquals(1, _walker.x);
            // a platform that is not there any more
            _queries.update(new <Agent>[_walker]);
            _options.fall = 0;
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertEquals(1, _walker.x);
            assertTrue(!_footing.stands);
        }

        /** For a BinCollider no agent is turned. So in the walk after it is exchanged, the floor's rotation is no turn, but its motion counts. */
        [Test]
        public function anotherCollisionSystemTurnsNobody():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var floor:Agent = agentAt("cube", 0, 0, 0);
            floor.size = 4;
            floor.heading = 90;
            _walker = agentAt("cube", 0.3, 0.2, 6);
            _walker.size = 0.5;
            _queries = new AgentQueries(collision);
            _options.fall = Infinity;
            for each (var system:CollisionSystem in [new BinCollider(), new TightestFitCollider(_greatLand), new BinCollider()])
            {
                collision.collisionSystem = system;
                floor.x += 0.125;
                _queries.update(new <Agent>[floor, _walker]);
                _queries.walk(_walker, 0, 0, _options, _footing);
                assertStrictlyEquals(floor, _footing.on);
                assertTrue(_walker.x + ", " + _walker.heading, Math.abs(_walker.x - 0.3 - (floor.x - 0.125)) < NEAR && _walker.heading == 0);
            }
        }

        /** A snapshot that a game goes back to in the frame of such an exchange has the rotation that did not count. */
        [Test]
        public function anotherCollisionSystemTurnsNobodyAfterASnapshotEither():void
        {
            var collision:Collision = new Collision(new BinCollider());
            var floor:Agent = agentAt("cube", 0, 0, 0);
            floor.size = 4;
            floor.heading = 30;
            _walker = agentAt("cube", 0.3, 0, 6);
            _walker.size = 0.5;
            var agents:Vector.<Agent> = new <Agent>[floor, _walker];
            _queries = new AgentQueries(collision);
            _options.fall = Infinity;
            _queries.update(agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
            collision.update(agents);
            collision.restore(collision.snapshot(), agents);
            collision.collisionSystem = new TightestFitCollider(_greatLand);
            floor.z += 0.1;
            _queries.update(agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertEquals(0, _walker.heading);
            assertTrue(_walker.x + ", " + _walker.y, Math.abs(_walker.x - 0.3) < NEAR && Math.abs(_walker.y) < NEAR);
        }

        /** What grows takes along who stands on it, also after a snapshot. */
        [Test]
        public function whatGrowsTakesAlongAfterASnapshotToo():void
        {
            var places:Array = [];
            for each (var isRestored:Boolean in [false, true])
            {
                var collision:Collision = new Collision(new BinCollider());
                var floor:Agent = agentAt("cube", 0, 0, 0);
                floor.size = 4;
                floor.heading = 90;
                _walker = agentAt("cube", 0.3, 0.2, 6);
                _walker.size = 0.5;
                var agents:Vector.<Agent> = new <Agent>[floor, _walker];
                _queries = new AgentQueries(collision);
                _options.fall = Infinity;
                _queries.update(agents);
                _queries.walk(_walker, 0, 0, _options, _footing);
                collision.update(agents);
                if (isRestored)
                {
                    collision.restore(collision.snapshot(), agents);
                }
                floor.size = 5;
                _queries.update(agents);
                _queries.walk(_walker, 0, 0, _options, _footing);
                places.push([_walker.x, _walker.y, _walker.z, _walker.heading].join());
            }
            assertEquals(places[0], places[1]);
            assertTrue(places[0], Math.abs(_walker.x - 0.3 * 5 / 4) < NEAR);
        }

        [Test]
        public function aRefusedWalkMovesNothing():void
        {
            begin("tightest fits");
            _floor.moveTo(1, 0, -4);
            _floor.heading = 20;
            _wall.moveTo(0.7, 0, 0);
            _queries.update(_agents);
            assertThrows(RangeError, /motion/, _queries.walk, _walker, NaN, 0, _options, _footing);
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                throw new Error("accepts");
            };
            _options.filter = filter;
            assertThrows(Error, /accepts/, _queries.walk, _walker, 1, 0, _options, _footing);
            assertEquals(0, _walker.x);
            assertEquals(0, _walker.heading);
            // a platform that the filter excludes does not carry
            _options.filter = AgentFilter.ofBreeds("walls");
            _options.fall = 0;
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertEquals(0, _walker.heading);
            _options.filter = null;
            begin("tightest fits");
            _floor.moveTo(1, 0, -4);
            _floor.heading = 20;
            _wall.moveTo(0.7, 0, 0);
            _queries.update(_agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertTrue([_walker.x, _walker.heading, _footing.pushed].join(), Math.abs(_walker.heading - 20) < NEAR && !_queries.touchesAny(_walker));
        }

        // The rows near a walk are those that its options reach when it begins.
        [Test]
        public function optionsThatAcceptsChangesCountInTheNextWalk():void
        {
            for each (var property:String in ["fall", "snap", "stepHeight", "slopeDegrees", "filter"])
            {
                var ends:Array = [];
                for each (var value:Number in [0.25, 20])
                {
                    begin("tightest fits");
                    _walker.moveTo(0, 0, 5);
                    _wall.moveTo(0.9, 0, 5);
                    _queries.update(_agents);
                    _options = new WalkOptions();
                    _options.filter = new AgentFilter();
                    _options.filter.accepts = accepts;
                    _queries.walk(_walker, 0.1, 0, _options, _footing);
                    ends.push([_walker.x, _walker.z, _footing.stands].join());
                }
                assertEquals(property, ends[0], ends[1]);
            }

            function accepts(agent:Agent):Boolean
            {
                _options[property] = property == "filter" ? null : value;
                return true;
            }
        }

        private function carryOnce(x:Number):void
        {
            _floor.moveTo(x, 0, -4);
            _queries.update(_agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
        }

        // A walker of half a patch stands on a large cube, beside another that is far away.
        private function begin(name:String):void
        {
            _walker = agentAt("cube", 0, 0, 0, "walkers");
            _walker.size = 0.5;
            _floor = agentAt("cube", 0, 0, -4, "floors");
            _floor.size = 4;
            _wall = agentAt("cube", 9, 0, 0, "walls");
            _agents = new <Agent>[_walker, _floor, _wall];
            for each (var agent:Agent in _agents)
            {
                agent.hierarchical = true;
            }
            _queries = new AgentQueries(EachCollider.make(name, _greatLand));
            _queries.update(_agents);
            _queries.walk(_walker, 0, 0, _options, _footing);
        }
    }
}

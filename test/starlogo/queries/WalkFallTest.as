package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.FrameByFrame;
    import support.agentAt;
    import support.assertThrows;
    import support.fillHeights;
    import support.landOf;

    /** Walks that fall, slide down what is too steep, begin in the air, and come to rest. What they may do follows from the slopes alone. */
    public class WalkFallTest
    {
        private static const NEAR:Number = 1e-6;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _random:SeededRandom = new SeededRandom(6151);
        private var _wrong:Complaints = new Complaints();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _terrain:Terrain;
        private var _queries:AgentQueries;
        private var _walker:Agent;
        private var _falls:int = 0;

        // rocks may push the walker, so that slopes do not explain where it goes
        private var _hasRocks:Boolean = false;

        // No walk ends higher than steps and slopes explain, none goes farther sideways than it goes down, and none farther than its way.
        [Test(async, timeout="3600000")]
        public function noWalkGoesWhereNoSlopeLeads():void
        {
            var worlds:int = Effort.choose(12, 300, 2);
            FrameByFrame.repeat(this, worlds * EachCollider.ALL_NAMES.length, function(i:int):void
                {
                    walkThrough(EachCollider.ALL_NAMES[int(i / worlds)], i % worlds);
                }, function():void
                {
                    _wrong.assertNone();
                    assertTrue(String(_falls), _falls > Effort.choose(50, 50, 30));
                });
        }

        // Nothing is below the walker. A wall beside it touches it, and so does a floor above it.
        [Test]
        public function anEndlessFallThatIsUndoneDoesNotPushTheAgent():void
        {
            _queries = new AgentQueries(EachCollider.make("tightest fits", _greatLand));
            _walker = agentAt("cube", 1, 0, 0);
            _queries.update(new <Agent>[_walker, agentAt("cube", 0, 0, 0.3), agentAt("cube", 1.5, 0, 1)]);
            _options.fall = Infinity;
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertFalse(_footing.stands);
            assertTrue(String(_walker.x - 1), Math.abs(_walker.x - 1) < 1e-9);
            assertTrue(String(_walker.z), Math.abs(_walker.z) < 1e-9);
        }

        private function walkThrough(name:String, world:int):void
        {
            makeWorld(name, world);
            for (var i:int = 0; i < 25; i++)
            {
                if (Math.abs(_walker.x) > 10 || Math.abs(_walker.y) > 10)
                {
                    land(-0.8 * _walker.x, -0.8 * _walker.y);
                }
                walkOnce(name + " " + world);
            }
        }

        // Where an agent cannot go down any more it stays, to the bit, whether it stands or not.
        [Test(async, timeout="3600000")]
        public function whatCannotFallRests():void
        {
            var wedged:int = 0;
            var worlds:int = Effort.choose(10, 100, 2);
            FrameByFrame.repeat(this, worlds * EachCollider.ALL_NAMES.length, function(i:int):void
                {
                    rest(EachCollider.ALL_NAMES[int(i / worlds)], i % 2 == 0);
                    wedged += _footing.stands ? 0 : 1;
                }, function():void
                {
                    _wrong.assertNone();
                    assertTrue(String(wedged), wedged > 5);
                });
        }

        private function rest(name:String, isStraight:Boolean):void
        {
            makeWorld(name, 3);
            fillHeights(_terrain, grooveOf(_random.between(1.2, 3), _random.between(1.2, 3), isStraight ? 0 : _random.between(-1, 1)));
            _terrain.isBlocky = false;
            _options.slopeDegrees = 45;
            _options.fall = 0.5;
            land(_random.between(-3, 3), _random.between(-3, 3));
            for (var i:int = 0; i < Effort.choose(60, 90); i++)
            {
                _queries.walk(_walker, 0, 0, _options, _footing);
            }
            var at:String = [_walker.x, _walker.y, _walker.z].join();
            _queries.walk(_walker, 0, 0, _options, _footing);
            _wrong.addIf([_walker.x, _walker.y, _walker.z].join() != at, name + ": trembles", at + " to " + [_walker.x, _walker.y, _walker.z]);
        }

        [Test]
        public function besideTheGroundThereIsNothingToStandOn():void
        {
            _options.fall = Infinity;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var shape:String in ["sphere", "cube"])
                {
                    for each (var isBlocky:Boolean in [false, true])
                    {
                        _terrain = new Terrain(5, 5, 1, -2, -2);
                        _terrain.isBlocky = isBlocky;
                        _walker = agentAt(shape, isBlocky ? 3 : 2.5, 0.1, 0.3);
                        ask(name);
                        for (var i:int = 0; i < 4; i++)
                        {
                            _queries.walk(_walker, 0, 0, _options, _footing);
                            assertFalse([name, shape, isBlocky, i, _walker.z].join(), _footing.stands);
                            assertTrue([name, shape, isBlocky, i, _walker.z].join(), Math.abs(_walker.z - 0.3) < NEAR);
                        }
                    }
                }
            }
        }

        // A wall of the ground has no lower end. In a fall without end, rounding would make a floor of it.
        [Test]
        public function aSmallAgentFindsNoFloorInAHole():void
        {
            _options.fall = Infinity;
            for each (var shape:String in ["sphere", "cube"])
            {
                for each (var size:Number in [1e-6, 1e-5, 1e-3])
                {
                    _terrain = new Terrain(11, 11, size, -5 * size, -5 * size);
                    _walker = agentAt(shape, size, size, size);
                    _walker.size = size;
                    ask("tightest fits");
                    for each (var corner:Array in [[5, 5], [6, 5], [5, 6], [6, 6]])
                    {
                        _terrain.setHole(corner[0], corner[1], true);
                    }
                    staysInTheAir(shape + " " + size + " over a hole");
                    // beside the end of the ground
                    _walker.moveTo(5.6 * size, 0, size);
                    staysInTheAir(shape + " " + size + " beside the ground");
                }
            }
        }

        private function staysInTheAir(name:String):void
        {
            var z:Number = _walker.z;
            _queries.moved(_walker);
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertTrue(name + ": " + _walker.z, !_footing.stands && _walker.z == z);
        }

        [Test]
        public function aFallOutOfTheWorldIsRefused():void
        {
            _terrain = null;
            _walker = agentAt("cube", 0, 0, -1e9 + 3);
            ask("tightest fits");
            _options.fall = 3;
            _queries.walk(_walker, 0, 0, _options, _footing);
            assertEquals(-1e9, _walker.z);
            assertThrows(RangeError, "-1000000003", _queries.walk, _walker, 0, 0, _options, _footing);
            assertEquals(-1e9, _walker.z);
            _options.fall = Infinity;
            staysInTheAir("at the end of the world");
        }

        [Test]
        public function aWalkThatBeginsInTheAirClimbsNothing():void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for each (var shape:String in ["sphere", "cube", "cylinder"])
                {
                    _terrain = new Terrain(24, 5, 1, -2, -2);
                    fillHeights(_terrain, function(column:int, row:int):Number
                        {
                            return 0.7 * column;
                        });
                    _walker = agentAt(shape, 0, 0.1, 3.5);
                    ask(name);
                    for each (var way:Number in [0.8, 12])
                    {
                        _walker.moveTo(0, 0.1, 3.5);
                        _queries.moved(_walker);
                        _queries.walk(_walker, way, 0, _options, _footing);
                        assertTrue([name, shape, way, _walker.x, _walker.z].join(), _walker.z <= 3.5 + NEAR && _walker.x > 0.7);
                    }
                    assertTrue(name + ": it stands on the ramp", _footing.stands);
                    var z:Number = _walker.z;
                    _queries.walk(_walker, 1, 0, _options, _footing);
                    assertTrue(name + ": and climbs it " + [z, _walker.z], Math.abs(_walker.z - z - 0.7) < 1e-3);
                }
            }
        }

        // A fall that ends on the ground stands there in the same walk, even if nothing has stopped it.
        [Test]
        public function aFallOfTheWholeHeightStands():void
        {
            var terrain:Terrain = new Terrain(5, 5, 1, -2, -2);
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                _terrain = terrain;
                _walker = agentAt("cube", 0, 0, 0);
                ask(name);
                land(0, 0);
                var lowest:Number = _walker.z;
                for each (var fall:Number in [0.5, 0.25])
                {
                    _options.fall = fall;
                    _walker.moveTo(0, 0, lowest + 0.5);
                    var falls:int = 0;
                    do
                    {
                        falls++;
                        _queries.walk(_walker, 0.01, 0, _options, _footing);
                    }
                    while (!_footing.stands && falls < 9);
                    assertEquals(name, 0.5 / fall, falls);
                    assertTrue(name + ": " + _walker.z, Math.abs(_walker.z - lowest) < NEAR);
                }
            }
        }

        // A sphere touches a floor and an edge that is too high for it. The way down meets the edge first.
        [Test]
        public function whatStandsDoesNotDependOnTheFall():void
        {
            for each (var above:Number in [1e-7, 4e-7, 8e-7])
            {
                _walker = agentAt("sphere", 0, 0, above);
                _walker.collideAs = "sphere";
                var floor:Agent = agentAt("cube", 0, 0, -4);
                floor.size = 4;
                var edge:Agent = agentAt("cube", 0.5 + Math.sqrt(0.25 - (0.2 + above) * (0.2 + above)) + 1e-9, 0, -0.7);
                _terrain = null;
                ask("tightest fits", [floor, edge]);
                _options.stepHeight = 0.1;
                for each (var fall:Number in [0, 0.5])
                {
                    _options.fall = fall;
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertTrue([above, fall].join(), _footing.stands && _footing.on === floor && _walker.x == 0 && _walker.z == above);
                }
            }
        }

        // A sphere stands on the upper edge of a thin wall, and walks off. The edge stops its fall and leads it aside, so it comes farther than its
        // way, by half of the fall at most.
        [Test]
        public function aThinWallLeadsAFallAside():void
        {
            _greatLand.prepareExact = true;
            _greatLand.addModel(new Model("sheets", new <Number>[-3, -3, 0, 3, -3, 0, 3, 3, 0, -3, 3, 0, 0, -3, 0.2, 0, 3, 0.2, 0, -3, 0, 0, 3, 0],
                        new <uint>[0, 1, 2, 0, 2, 3, 6, 7, 5, 6, 5, 4], Model.AS_GIVEN));
            var sheets:Agent = agentAt("sheets", 0, 0, 0);
            sheets.hierarchical = true;
            for each (var fall:Number in [0, 0.1, 0.2, 0.5])
            {
                _walker = agentAt("sphere", -0.03, 0, 0.3);
                _walker.size = 0.7;
                _terrain = null;
                ask("combinations, exact", [sheets]);
                _options.fall = Infinity;
                _queries.walk(_walker, 0, 0, _options, _footing);
                var z:Number = _walker.z;
                _options.fall = fall;
                _queries.walk(_walker, 0.3, 0, _options, _footing);
                var farther:Number = _walker.x + 0.03 - 0.3;
                assertTrue([fall, z, farther].join(), Math.abs(z - 0.1987) < 1e-4 && Math.abs(_footing.part - 1) < NEAR);
                assertTrue([fall, farther].join(), farther > -NEAR && farther < fall / 2 + NEAR && farther > NEAR == fall > 0.1);
                assertEquals(fall == 0.5, _footing.stands);
            }
        }

        // The edge of a column carries a sphere up to a step above its lowest point, in the first frame as in the next ones.
        [Test]
        public function anEdgeThatIsTooHighCarriesForNoFrame():void
        {
            var edges:int = 0;
            for each (var height:Number in [0.5, 2])
            {
                for (var steps:int = 20; steps < 30; steps++)
                {
                    _terrain = new Terrain(5, 5, 1, -2, -2);
                    _terrain.isBlocky = true;
                    _terrain.setHeight(2, 2, height);
                    _walker = agentAt("sphere", 0.2, 0.05, height + 0.01);
                    ask("tightest fits");
                    for (var i:int = 0; i < steps; i++)
                    {
                        _queries.walk(_walker, 0.03, 0, _options, _footing);
                        var isOnEdge:Boolean = _walker.z > NEAR && _footing.stands && _walker.x > 0.5;
                        edges += isOnEdge ? 1 : 0;
                        assertTrue([height, steps, i, _walker.x, _walker.z].join(), !isOnEdge || height - _walker.z <= 0.25 + NEAR);
                    }
                    for (i = 0; i < 9; i++)
                    {
                        _queries.walk(_walker, 0, 0, _options, _footing);
                    }
                    assertTrue([height, steps, _walker.x, _walker.z].join(), _footing.stands && (_walker.z < NEAR || height - _walker.z <= 0.25));
                }
            }
            assertTrue(String(edges), edges > 20);
        }

        // On the edge of a low column the ground's normal is tilted. The plane of such a place would lead a long walk over any wall.
        [Test(async, timeout="3600000")]
        public function aLongWalkGoesOverNoWall():void
        {
            var far:int = 0;
            var worlds:int = Effort.choose(4, 40, 1);
            _options.fall = Infinity;
            FrameByFrame.repeat(this, worlds * EachCollider.NAMES.length, function(i:int):void
                {
                    far += walkAgainstWalls(EachCollider.NAMES[int(i / worlds)], i % worlds);
                }, function():void
                {
                    assertTrue("at the wall: " + far, far > 2);
                });
        }

        // Returns how many walks end at a wall.
        private function walkAgainstWalls(name:String, world:int):int
        {
            var far:int = 0;
            _terrain = new Terrain(21, 21, 1, -10, -10);
            _terrain.isBlocky = world % 2 == 0;
            fillHeights(_terrain, function(column:int, row:int):Number
                {
                    return Math.max(Math.abs(column - 10), Math.abs(row - 10)) == 8 ? 4 : _random.between(-0.1, 0.1);
                });
            _walker = agentAt(_random.pick(["sphere", "cube", "cylinder"]), 0, 0, 0.2);
            ask(name);
            for (var k:int = 0; k < Effort.choose(20, 20, 2); k++)
            {
                var angle:Number = _random.between(0, 2 * Math.PI);
                var way:Number = _random.between(1, 40);
                _queries.walk(_walker, way * Math.cos(angle), way * Math.sin(angle), _options, _footing);
                var message:String = name + " " + world + ", walk " + k + " of " + way + ": " + [_walker.x, _walker.y, _walker.z];
                assertTrue(message, Math.abs(_walker.x) < 8 && Math.abs(_walker.y) < 8 && _walker.z < 3.5);
                far += Math.max(Math.abs(_walker.x), Math.abs(_walker.y)) > 5 ? 1 : 0;
            }
            return far;
        }

        [Test]
        public function whatIsInTheWayOfASlideDownStopsIt():void
        {
            _options.fall = 0.5;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                _terrain = new Terrain(9, 9, 1, -4, -4);
                fillHeights(_terrain, function(column:int, row:int):Number
                    {
                        return -2 * column;
                    });
                _walker = agentAt("sphere", 0, 0.1, -7.5);
                _walker.size = 0.5;
                var rock:Agent = agentAt("cube", 2.3, 0.1, -9.5);
                rock.size = 4;
                rock.hierarchical = true;
                ask(name, [rock]);
                for (var i:int = 0; i < 5; i++)
                {
                    _queries.walk(_walker, 0, 0, _options, _footing);
                    assertFalse(name + ": " + [i, _walker.x, _walker.z], _queries.touchesAny(_walker));
                }
                assertTrue(name + ": " + _walker.x, _walker.x > 0.04 && _walker.x < 0.06);
            }
        }

        private function makeWorld(name:String, world:int):void
        {
            _terrain = new Terrain(24, 24, 1, -12, -12);
            _terrain.isBlocky = world % 4 == 1;
            var rough:Number = _random.pick([0.3, 0.6, 1, 2]);
            fillHeights(_terrain, world % 4 == 2 ? grooveOf(_random.between(0.5, 3), _random.between(0.5, 3), _random.between(-1, 1)) : function(column:int, row:int):Number
                {
                    return _random.between(-rough, rough);
                });
            _options.slopeDegrees = _random.pick([30, 45, 60]);
            _options.stepHeight = _random.pick([0, 0.1, 0.25, 0.5]);
            _options.snap = _random.pick([0.1, 0.25, 0.5]);
            _options.fall = _random.pick([0, 0.1, 0.5, 2]);
            _walker = agentAt(_random.pick(["sphere", "cube", "cylinder"]), 0, 0, 0);
            _walker.size = _random.pick([0.2, 0.5, 1.2]);
            _walker.heading = _random.between(0, 360);
            _hasRocks = world % 3 == 2;
            var rocks:Array = [];
            for (var i:int = 0; i < 40 && _hasRocks; i++)
            {
                rocks.push(agentAt("cube", _random.between(-10, 10), _random.between(-10, 10), _random.between(-1, 0.5)));
                rocks[i].heading = _random.between(0, 360);
                rocks[i].pitch = _random.between(-40, 40);
                rocks[i].hierarchical = true;
            }
            ask(name, rocks);
            land(_random.between(-9, 9), _random.between(-9, 9));
        }

        private function ask(name:String, rocks:Array = null):void
        {
            _queries = new AgentQueries(EachCollider.make(name, _greatLand));
            _queries.terrain = _terrain;
            _queries.update(Vector.<Agent>([_walker].concat(rocks || [])));
        }

        // Puts the walker on the ground.
        private function land(x:Number, y:Number):void
        {
            _walker.moveTo(x, y, 200);
            _queries.moved(_walker);
            _queries.moveUntilTouch(_walker, 0, 0, -400);
            _queries.walk(_walker, 0, 0, _options, _footing);
        }

        private function walkOnce(name:String):void
        {
            var way:Number = _random.pick([0, 0.01, 0.05, 0.1, 0.3]);
            var turn:Number = _random.between(0, 7);
            var x:Number = _walker.x;
            var y:Number = _walker.y;
            var z:Number = _walker.z;
            var stood:Boolean = _footing.stands;
            _queries.walk(_walker, way * Math.cos(turn), way * Math.sin(turn), _options, _footing);
            var rise:Number = _walker.z - z;
            var gone:Number = Math.sqrt((_walker.x - x) * (_walker.x - x) + (_walker.y - y) * (_walker.y - y));
            var steepest:Number = Math.tan(_options.slopeDegrees * Math.PI / 180);
            var climbed:Number = Math.ceil(way / _walker.size) * _options.stepHeight + way * steepest;
            var message:String = [x, y, z].join() + " of " + way + " to " + [_walker.x, _walker.y, _walker.z] + ", " + stood + ", " + _footing.stands;
            _falls += _footing.stands ? 0 : 1;
            var rounding:Number = 1e-9 * (way + _options.fall + _walker.size);
            _wrong.addIf(gone > way + _options.fall / 2 + rounding, name + ": farther than its way", message);
            _wrong.addIf(_options.fall == 0 && Math.abs(_footing.part * way - gone) > rounding, name + ": another part", message);
            _wrong.addIf(!_hasRocks && rise > (stood ? climbed : 0) + NEAR, name + ": too high", message);
            _wrong.addIf(!_hasRocks && gone > way + Math.max(0, climbed - rise) / steepest + NEAR, name + ": too far", message);
        }

        // Two slopes that meet in a level groove.
        private static function grooveOf(left:Number, right:Number, turn:Number):Function
        {
            return function(column:int, row:int):Number
            {
                var across:Number = column - 12 + turn * (row - 12);
                return across > 0 ? right * across : -left * across;
            };
        }
    }
}

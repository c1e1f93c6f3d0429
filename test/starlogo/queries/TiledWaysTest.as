// This file is long because each kind of place is a test.
package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;

    /**
     * Ways among things that touch exactly, in every system: floors, corridors and mazes of cubes side by side. A motion is stopped by what it would go into,
     * never by what it touches, leaves or runs along.
     */
    public class TiledWaysTest
    {
        private static const HAIR:Number = 1e-9;
        private static const MOVERS:Array = ["cube", "sphere", "cylinder"];

        // With the tightest fits alone, and with all structures.
        private static var sLands:Vector.<GreatLand>;

        private var _random:SeededRandom = new SeededRandom(3301);
        private var _wrong:Complaints = new Complaints();
        private var _cases:int = 0;

        // The world under way.
        private var _collider:Collider;
        private var _system:String;
        private var _agents:Vector.<Agent>;
        private var _queries:AgentQueries;

        [BeforeClass]
        public static function makeModels():void
        {
            sLands = new Vector.<GreatLand>();
            for each (var all:Boolean in [false, true])
            {
                var land:GreatLand = new GreatLand();
                land.loadAllBoundingStructures = all;
                land.addModel(BuiltInModel.cube());
                land.addModel(BuiltInModel.sphere());
                land.addModel(BuiltInModel.cylinder());
                land.addModel(stretched("plate", 1, 1, 0.001));
                land.addModel(stretched("sheet", 1, 1, 0));
                land.addModel(stretched("board", 0.001, 1, 1));
                land.addModel(tip());
                sLands.push(land);
            }
        }

        [Test]
        public function overFloorsAtAllAngles():void
        {
            var depths:SeededRandom = new SeededRandom(2411);
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : MOVERS.concat("plate", "sheet"))
                    {
                        for (var i:int = 0; i < Effort.choose(3, 60); i++)
                        {
                            var hardly:Number = _random.pick([-1, 1]) * _random.logBetween(1e-17, 0.01);
                            var way:Array = [0.3, _random.pick([0, 0, 0.05, 0.2]), _random.pick([hardly, hardly, hardly, 0, -0.3, -1])];
                            var mover:Agent = put(shape, 0, 0, _random.pick([0, 1e-12, 1e-10, 1e-8]), _random.pick([0, 0, 30]));
                            floor(9, 1);
                            step(mover, way, 20);
                            expect(mover.x > 5.999, "stuck", mover, way);
                            expectShallow(mover);
                            // a little in the floor, as from numbers of single precision
                            var sunk:Number = depths.pick([0, 0, 1e-9, 1e-7, 0.9e-6]);
                            mover.moveTo(0, 0, -sunk);
                            for (var k:int = 0; k < 20; k++)
                            {
                                _queries.moveUntilTouch(mover, way[0], 0, way[2]);
                            }
                            expect(mover.x > 5.999 || way[2] < -1e-13, "stops", mover, way.concat(sunk));
                            // a motion shorter than a slop may lead deeper into what is overlapped already
                            expectShallow(mover, sunk > 0 ? sunk + 20 * HAIR : 0);
                        }
                    }
                });
        }

        /** The core reaches the edge of a tile with its own edge: it enters the top and leaves the side at the same time, but for rounding. */
        [Test]
        public function atEdgesReachedByEdges():void
        {
            var clearance:Number = 1.0501733078003133e-10;
            var places:Array = [[0.3, 2 - 8 * clearance, 0, 0.3, 1], [0.3, 3 - clearance, clearance, 0.3, 1], [0.3, 3 - 2 * clearance, 2 * clearance, 0.3, 1],
                    [0.9, 2.9999999998949827, clearance, 0.3, 1], [0.9, 2 - 8 * clearance, 0, 0.3, 1], [0.5, 3 - 6 * clearance, 0, 0.3, 0.5],
                    [0, 3 - 8 * clearance, 0, 0, 1], [0.3, 2 - 6 * clearance, 0, 0.3, 0.5]];
            eachSystem(function(isBins:Boolean):void
                {
                    var mover:Agent = put("cube", 0, 0, 0, 0);
                    floor(6, 2);
                    for each (var place:Array in isBins ? [] : places)
                    {
                        mover.moveTo(place[0], place[1], place[2]);
                        step(mover, [place[3], place[4], -1], 1);
                        expect(mover.x > place[0] + 0.99 * place[3] - 0.001 && mover.y > place[1] + 0.99 * place[4], "stuck", mover, place);
                        expectShallow(mover);
                    }
                });
        }

        /** The lowest corner of a cylinder enters a floor exactly between two tiles: along the sides of both. */
        [Test]
        public function betweenTiles():void
        {
            var places:Array = [[1.9999999992913684, 1], [1.999999999369896, 0.5], [2.999999999369896, 1], [1.9999999992648787, 1], [2.9999999994749134, 0.5]];
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var side:int in isBins ? [] : [-1, 2])
                    {
                        var mover:Agent = put("cylinder", 0, 0, 0, 0);
                        floor(3, side);
                        for each (var place:Array in places)
                        {
                            mover.moveTo(0.5, place[0], 1.0501733078003133e-10);
                            step(mover, [0, place[1], -place[1]], 1);
                            expect(mover.y > place[0] + 0.99 * place[1], "stuck", mover, place);
                            expectShallow(mover);
                        }
                    }
                });
        }

        /** The lowest corner of what leans over comes down exactly on the border of tiles, which may be one-way. It is stopped as by one tile. */
        [Test]
        public function aTipBetweenTiles():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for (var i:int = Effort.choose(30, 300, 4); i > 0 && !isBins; i--)
                    {
                        var mover:Agent = put("tip", 0, 0, 0, _random.between(0, 360));
                        mover.collideAs = Agent.HULL;
                        floor(3, 1);
                        for each (var tile:Agent in _agents)
                        {
                            tile.isOneWay = i % 4 < 2;
                        }
                        var way:Array = [_random.pick([0, _random.between(-0.3, 0.3)]), _random.pick([0, _random.between(-0.3, 0.3)]), -1];
                        var before:Number = _random.between(0.05, 0.4);
                        mover.moveTo(0.5 - before * way[0], _random.pick([0.5, _random.between(-0.5, 1.5)]) - before * way[1], before);
                        step(mover, way, 1, i % 2 == 0);
                        expect(Math.abs(mover.z) < HAIR, "not on the tiles", mover, way);
                    }
                });
        }

        /** A corner meets the edge between two tiles at a grazing angle to its own side, so rounding hides the touch at the computed place. */
        [Test]
        public function aCornerGoesNoDeeperThanItsTouch():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    if (isBins)
                    {
                        return;
                    }
                    var mover:Agent = put("cube", 0, 0, 0, 30);
                    mover.size = 0.2;
                    for each (var place:Array in [[0, 0.2, 0], [0.1, 0.2, 0], [0.2, 0, 0.1]])
                    {
                        var tile:Agent = agentAt("cube", place[0], place[1], place[2]);
                        tile.size = 0.1;
                        add(tile);
                    }
                    for each (var from:Number in [0, 0.001])
                    {
                        mover.moveTo(from, from, 0);
                        step(mover, [0.05, 0.05, 0], 1, false);
                        expect(mover.x > 0.0133, "too short", mover, [from]);
                        expectShallow(mover);
                    }
                });
        }

        [Test]
        public function inCorridorsAsWide():void
        {
            var ways:Array = [[0.3, 0.05, 0], [0.3, 0, 0], [0.3, -0.3, 0], [0.3, 1, 0]];
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in MOVERS)
                    {
                        for each (var way:Array in some(ways, 2))
                        {
                            expectCorridor(shape, way, _random.pick([6, 40]), isBins);
                        }
                    }
                });
        }

        // From one end to the other, by steps, at once, and back.
        private function expectCorridor(shape:String, way:Array, pairs:int, isBins:Boolean):void
        {
            var mover:Agent = put(shape, 0, 0, 0, 0);
            if (!isBins && _collider.areColliding(mover, agentAt("cube", 0, 1 + 1e-6, 0)))
            {
                // wider than the corridor
                return;
            }
            for (var i:int = -2; i < pairs; i++)
            {
                add(agentAt("cube", i, 1, 0), agentAt("cube", i, -1, 0));
            }
            var last:Number = pairs - 2;
            add(agentAt("cube", last + 1, 0, 0));
            var steps:int = Math.min(pairs / 0.3 + 5, 40);
            step(mover, way, steps);
            expect(isBins || Math.abs(mover.x - Math.min(steps * way[0], last)) < 0.01, "stuck", mover, way);
            expectShallow(mover);
            for each (var slides:Boolean in [false, true])
            {
                mover.moveTo(0, 0, 0);
                step(mover, [pairs + 20, 0, 0], 1, slides);
                expect(mover.x < last + 1e-7 && (isBins || mover.x > last - 0.01), "through, or too short", mover, [slides]);
                expectShallow(mover);
            }
            mover.moveTo(last, 0, 0);
            step(mover, [-pairs - 20, 0, 0], 1);
            expect(isBins || mover.x < -19, "no way back", mover, []);
        }

        [Test]
        public function neverCreeps():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in some(MOVERS.concat("plate", "board"), 1))
                    {
                        var mover:Agent = put(shape, 0, 0, 0, _random.pick([0, 30]));
                        var wall:Agent = agentAt("cube", 5, 0, -2);
                        wall.size = 6;
                        add(wall);
                        var way:Array = _random.pick([[0.5, 0, 0], [0.5, 0, -1e-3], [0.01, 0.001, 0]]);
                        step(mover, way, 2000, false);
                        expect(_collider.areColliding(mover, wall), "no touch", mover, way);
                        expectShallow(mover);
                    }
                });
        }

        // Each step is shorter than the clearance between an agent and what it is lifted out of.
        [Test]
        public function neverCreepsByShortSteps():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : some(MOVERS.concat("plate", "sheet"), 3))
                    {
                        for each (var sunk:Number in [0, 1e-8])
                        {
                            var mover:Agent = put(shape, 0, 0, 0, _random.pick([0, 30]));
                            floor(2, 1);
                            mover.moveTo(0, 0, -sunk);
                            var way:Array = [_random.pick([0, 1e-6]), 0, -_random.logBetween(1e-12, 1e-9)];
                            step(mover, way, Effort.choose(200, 1000), false);
                            // The corner of four tiles may push a mover of triangles to the side, so that a hair of one tile adds to that of another.
                            expectShallow(mover, sunk + HAIR);
                            expect(mover.z <= 0 && Math.abs(mover.x) < 0.01, "elsewhere", mover, way);
                        }
                    }
                });
        }

        [Test]
        public function anythingAmongTiles():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    var gone:Number = 0;
                    var turns:int = Effort.choose(2, 60);
                    for (var i:int = turns; i > 0; i--)
                    {
                        var tile:Number = _random.pick([1, 0.1, 3]);
                        var mover:Agent = put(_random.pick(MOVERS), 0, 0, 0, _random.pick([0, 30, 90]));
                        mover.size = tile * _random.pick([1, 1, 0.5, 2]);
                        for (var k:int = 0; k < 40; k++)
                        {
                            var other:Agent = agentAt("cube", tile * _random.integer(-4, 4), tile * _random.integer(-4, 4), tile * _random.integer(-1, 1));
                            other.size = tile;
                            add(other);
                            if (_collider.areColliding(mover, other) && _collider.contactOf(mover, other).depth > 1e-12)
                            {
                                _agents.pop();
                            }
                        }
                        for (k = 0; k < 12; k++)
                        {
                            var way:Array = [_random.integer(-2, 2) / 4 * tile, _random.integer(-2, 2) / 4 * tile, _random.integer(-1, 1) / 4 * tile];
                            gone += step(mover, way, 1, _random.chance());
                            expectShallow(mover);
                        }
                    }
                    assertTrue(_system + ": " + gone, gone > turns);
                });
        }

        // Plays something in each system, with each land where that makes a difference.
        private function eachSystem(play:Function):void
        {
            for each (_system in EachCollider.ALL_NAMES)
            {
                for each (var land:GreatLand in sLands)
                {
                    if (land === sLands[0] || _system == "tightest fits" || _system.indexOf("combinations") == 0)
                    {
                        _collider = EachCollider.make(_system, land);
                        play(_system == "bins");
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(_cases + " cases", _cases >= 9);
        }

        // All of an array, or so many of it.
        private function some(all:Array, count:int):Array
        {
            var first:int = Effort.isFull ? 0 : _random.integer(0, all.length - 1);
            return all.slice(first).concat(all.slice(0, first)).slice(0, Effort.isFull ? all.length : count);
        }

        private function put(shape:String, x:Number, y:Number, z:Number, heading:Number):Agent
        {
            var mover:Agent = agentAt(shape, x, y, z);
            mover.heading = heading;
            _agents = new Vector.<Agent>();
            _queries = new AgentQueries(_collider);
            add(mover);
            return mover;
        }

        private function add(...agents):void
        {
            for each (var agent:Agent in agents)
            {
                // in combinations both kinds meet
                agent.hierarchical = _system == "combinations, exact" || _agents.length % 2 == 0;
                _agents.push(agent);
            }
        }

        // Cubes below z = 0.
        private function floor(length:int, side:int):void
        {
            for (var i:int = -2; i < length; i++)
            {
                for (var k:int = -side; k <= side + 4; k++)
                {
                    add(agentAt("cube", i, k, -1));
                }
            }
        }

        private function step(mover:Agent, way:Array, times:int, slides:Boolean = true):Number
        {
            _queries.update(_agents);
            var part:Number = 0;
            for (var i:int = 0; i < times; i++)
            {
                part = slides ? _queries.slide(mover, way[0], way[1], way[2]) : _queries.moveUntilTouch(mover, way[0], way[1], way[2]);
            }
            _cases++;
            return part;
        }

        private function expect(isRight:Boolean, problem:String, mover:Agent, details:Array):void
        {
            _wrong.addIf(!isRight, _system + ", " + mover.shape + ": " + problem, [mover.x, mover.y, mover.z, "by", details].join(" "));
        }

        private function expectShallow(mover:Agent, sunk:Number = 0):void
        {
            for each (var other:Agent in _agents)
            {
                if (other !== mover && _collider.areColliding(mover, other))
                {
                    var depth:Number = _collider.contactOf(mover, other).depth / Math.max(mover.size, other.size);
                    expect(depth <= sunk + HAIR, "deep", mover, [depth]);
                }
            }
        }

        // A tetrahedron that stands on its corner at the origin and leans over.
        private static function tip():Model
        {
            return new Model("tip", new <Number>[0, 0, 0, 1.4, 0.1, 1, 0.7, 0.35, 1.1, 0.8, -0.4, 0.9], new <uint>[0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3],
                    Model.AS_GIVEN);
        }

        private static function stretched(name:String, x:Number, y:Number, z:Number):Model
        {
            var cube:Model = BuiltInModel.cube();
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < cube.vertices.length; i += 3)
            {
                vertices.push(x * cube.vertices[i], y * cube.vertices[i + 1], z * cube.vertices[i + 2]);
            }
            return new Model(name, vertices, cube.triangles, Model.AS_GIVEN);
        }
    }
}

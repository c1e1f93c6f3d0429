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
    import support.SolidModels;

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

        private var _random:SeededRandom;
        private var _wrong:Complaints;
        private var _cases:int;

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
                land.addModel(SolidModels.of("U", [[1, -1, 0, 0, false], [1, -1, 1, 0, false], [1, -1, -1, 0, false], [1, 0, 1, 0, false], [1, 0, -1, 0, false]]));
                land.addModel(SolidModels.of("post", [[1, 0, 0, 0, false], [1, 0, 0, 1, false], [1, 0, 0, 2, false]]));
                land.addModel(stretched("plate", 1, 1, 0.001));
                land.addModel(stretched("sheet", 1, 1, 0));
                land.addModel(stretched("board", 0.001, 1, 1));
                land.addModel(plain(60));
                sLands.push(land);
            }
        }

        [AfterClass]
        public static function forgetModels():void
        {
            sLands = null;
        }

        [Before]
        public function begin():void
        {
            _random = new SeededRandom(3301);
            _wrong = new Complaints();
            _cases = 0;
        }

        [Test]
        public function overFloors():void
        {
            var ways:Array = [[0.3, 0, -0.1], [0.3, 0, -0.01], [0.3, 0, -1], [0.3, 0, -0.3], [0.3, 0.3, -0.3], [0.3, 0, 0], [1, 0, -1], [0.3, 0.05, -0.2]];
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in MOVERS.concat("plate", "sheet"))
                    {
                        for each (var way:Array in some(ways, 3))
                        {
                            var height:Number = _random.pick([0, 0, 1e-9, 1e-7]);
                            var mover:Agent = put(shape, 0, 0, height, _random.pick([0, 30]));
                            floor(14, 1);
                            step(mover, way, 10);
                            expect(isBins || mover.x > 9.9 * way[0], "stuck", mover, way);
                            expect(isBins || mover.z > -1e-8, "sinks", mover, way);
                            expectFree(mover, isBins);
                        }
                    }
                });
        }

        [Test]
        public function alongFloorsAtAllAngles():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : MOVERS.concat("plate"))
                    {
                        for (var i:int = 0; i < Effort.choose(3, 60); i++)
                        {
                            var way:Array = [0.3, 0, _random.pick([-1, 1]) * _random.logBetween(1e-17, 0.01)];
                            var mover:Agent = put(shape, 0, 0, _random.pick([0, 1e-12, 1e-10, 1e-8]), 0);
                            floor(9, 1);
                            step(mover, way, 20);
                            expect(mover.x > 5.999, "stuck", mover, way);
                            expectShallow(mover);
                            mover.moveTo(0, 0, 0);
                            for (var k:int = 0; k < 20; k++)
                            {
                                _queries.moveUntilTouch(mover, way[0], 0, way[2]);
                            }
                            expect(mover.x > 5.999 || way[2] < -1e-13, "stops", mover, way);
                            expectShallow(mover);
                        }
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

        [Test]
        public function inLongCorridors():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var pairs:int in Effort.isFull ? [200, 1000] : [_random.pick([200, 1000])])
                    {
                        expectCorridor(_random.pick(MOVERS), [0.3, 0.05, 0], pairs, isBins);
                    }
                });
        }

        // From one end to the other, by steps, at once, and back.
        private function expectCorridor(shape:String, way:Array, pairs:int, isBins:Boolean):void
        {
            var mover:Agent = put(shape, 0, 0, 0, 0);
            if (!isBins && _collider.areColliding(mover, cube(0, 1 + 1e-6, 0)))
            {
                // wider than the corridor
                return;
            }
            for (var i:int = -2; i < pairs; i++)
            {
                add(cube(i, 1, 0), cube(i, -1, 0));
            }
            var last:Number = pairs - 2;
            add(cube(last + 1, 0, 0));
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
        public function throughMazes():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : MOVERS)
                    {
                        for each (var tile:Number in [1, 0.1])
                        {
                            expectMaze(shape, tile, _random.pick([0, 30, 77]), _random.pick([0, 33.3, 1e6]));
                        }
                    }
                });
        }

        // East, north and east again.
        private function expectMaze(shape:String, tile:Number, heading:Number, far:Number):void
        {
            var cosine:Number = Math.cos(heading * Math.PI / 180);
            var sine:Number = Math.sin(heading * Math.PI / 180);
            var mover:Agent = put(shape, far, far, 0, heading);
            mover.size = tile;
            for (var i:int = -1; i <= 9; i++)
            {
                for (var k:int = -1; k <= 5; k++)
                {
                    var isOpen:Boolean = k == 0 && i >= 0 && i <= 4 || i == 4 && k >= 0 && k <= 4 || k == 4 && i >= 4 && i <= 8;
                    if (!isOpen)
                    {
                        var wall:Agent = cube(far + tile * (i * cosine - k * sine), far + tile * (i * sine + k * cosine), 0);
                        wall.size = tile;
                        wall.heading = heading;
                        add(wall);
                    }
                }
            }
            if (_collider.areColliding(mover, _agents[2]) && _collider.contactOf(mover, _agents[2]).depth > 1e-6 * tile)
            {
                return;
            }
            for each (var way:Array in [[0.3, 0.07], [0.05, 0.3], [0.3, 0.05]])
            {
                step(mover, [tile * (way[0] * cosine - way[1] * sine), tile * (way[0] * sine + way[1] * cosine), 0], 18);
            }
            var off:Number = Math.abs(mover.x - far - tile * (8 * cosine - 4 * sine)) + Math.abs(mover.y - far - tile * (8 * sine + 4 * cosine));
            expect(off < 1e-3 * tile + 1e-12 * far, "lost", mover, [tile, heading, far]);
        }

        [Test]
        public function overTerrainOfOneModel():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    if (_system != "triangles" && _system != "combinations, exact")
                    {
                        return;
                    }
                    for each (var shape:String in MOVERS)
                    {
                        var mover:Agent = put(shape, -20, -20, 0, _random.pick([0, 30]));
                        add(new Agent("plain"), cube(-5, -20, 0));
                        var way:Array = _random.pick([[0.3, 0.1, -0.1], [0.3, 0.3, -0.3], [0.31, 0.17, -1]]);
                        step(mover, way, 30);
                        expect(Math.abs(mover.x + 20 - 30 * way[0]) < 0.01, "stuck", mover, way);
                        expectShallow(mover);
                        mover.moveTo(-20, -20, 0);
                        var part:Number = step(mover, [40, 0, 0], 1, false);
                        expect(Math.abs(part - 14 / 40) < 0.02, "stops elsewhere", mover, [part]);
                        expectShallow(mover);
                    }
                });
        }

        [Test]
        public function exactlyRoundAPost():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    if (isBins || _system == "tightest fits")
                    {
                        // it has no U
                        return;
                    }
                    for each (var post:String in ["cube", "post"])
                    {
                        for each (var heading:Number in [0, 30, 90])
                        {
                            expectRoundPost(post, heading, _random.pick([1, 3]), _random.pick([0, 7.7, 1000]));
                        }
                    }
                });
        }

        private function expectRoundPost(shape:String, heading:Number, size:Number, far:Number):void
        {
            var cosine:Number = Math.cos(heading * Math.PI / 180);
            var sine:Number = Math.sin(heading * Math.PI / 180);
            var u:Agent = put("U", far, far, 0, heading);
            var post:Agent = cube(far + size / 6 * cosine, far + size / 6 * sine, 0);
            post.shape = shape;
            post.heading = heading;
            post.size = size / 3;
            u.size = size;
            add(post);
            for each (var slides:Boolean in [false, true])
            {
                for each (var way:Array in [[-2, 0, 0, true], [2, 0, 0, false], [0, 2, 0, false], [0, -2, 0, false], [0, 0, 3, true]])
                {
                    for each (var sign:int in [1, -1])
                    {
                        var mover:Agent = sign > 0 ? u : post;
                        var x:Number = mover.x;
                        var y:Number = mover.y;
                        var part:Number = step(mover, [sign * size * (way[0] * cosine - way[1] * sine), sign * size * (way[0] * sine + way[1] * cosine),
                                    size * way[2]], 1, slides);
                        expect(way[3] ? part > 0.999 : part < 1e-6, "a part of " + part, mover, way);
                        mover.moveTo(x, y, 0);
                    }
                }
            }
        }

        [Test]
        public function thinAndWide():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : ["plate", "sheet", "board"])
                    {
                        var size:Number = _random.pick([1, 30]);
                        var way:Array = _random.pick([[0.3, 0, -0.1], [0.3, 0, 0], [0.3, 0.02, -1]]);
                        var mover:Agent = put(shape, 0, 0, 0, _random.pick([0, 30]));
                        mover.size = size;
                        floor(8, 2);
                        step(mover, way, 10);
                        expect(Math.abs(mover.x - 3) < 1e-4 * size && mover.z > -1e-8 * size, "stuck", mover, way);
                        expectShallow(mover);
                        mover.moveTo(0, 0, 0);
                        expect(step(mover, [4, 0.3, 0], 1, false) == 1, "stops", mover, [size]);
                    }
                    if (!isBins)
                    {
                        // in a slot exactly as thick
                        mover = put("board", 0, 0, 0, 0);
                        for (var k:int = -2; k < 8; k++)
                        {
                            add(cube(0.5005, k, 0), cube(-0.5005, k, 0));
                        }
                        step(mover, [0.02, 0.3, 0], 15);
                        expect(Math.abs(mover.y - 4.5) < 1e-4 && Math.abs(mover.x) < 1e-9, "stuck in a slot", mover, []);
                    }
                });
        }

        [Test]
        public function farOut():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in isBins ? [] : MOVERS)
                    {
                        var far:Number = _random.pick([1e3, 1e6, 9e8, 12345678.9]);
                        var mover:Agent = put(shape, far, -far, 0, 0);
                        floor(8, 1);
                        for (var i:int = 1; i < _agents.length; i++)
                        {
                            _agents[i].moveTo(_agents[i].x + far, _agents[i].y - far, -1);
                        }
                        step(mover, [0.3, 0, -0.1], 15);
                        expect(Math.abs(mover.x - far - 4.5) < 1e-3 + 1e-12 * far && mover.z > -1e-8 - 1e-13 * far, "stuck", mover, [far]);
                    }
                });
        }

        [Test]
        public function grazedAndDeflectedIntoIt():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for (var i:int = 0; i < Effort.choose(8, 100); i++)
                    {
                        var mover:Agent = put("sphere", 0, 0, 0, 0);
                        add(ball(2, 1), ball(_random.between(3, 4), _random.between(-1, -0.2)), ball(4.3, 0.9));
                        for (var k:int = 0; k < 8; k++)
                        {
                            step(mover, [1, 0, 0], 1);
                            expectShallow(mover);
                        }
                    }
                });
        }

        [Test]
        public function neverCreeps():void
        {
            eachSystem(function(isBins:Boolean):void
                {
                    for each (var shape:String in some(MOVERS.concat("plate", "board"), 1))
                    {
                        var mover:Agent = put(shape, 0, 0, 0, _random.pick([0, 30]));
                        var wall:Agent = cube(5, 0, -2);
                        wall.size = 6;
                        add(wall);
                        var way:Array = _random.pick([[0.5, 0, 0], [0.5, 0, -1e-3], [0.01, 0.001, 0]]);
                        step(mover, way, 2000, false);
                        expect(_collider.areColliding(mover, wall), "no touch", mover, way);
                        expectShallow(mover);
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
                            var other:Agent = cube(tile * _random.integer(-4, 4), tile * _random.integer(-4, 4), tile * _random.integer(-1, 1));
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
            var mover:Agent = new Agent(shape);
            mover.moveTo(x, y, z);
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

        private static function cube(x:Number, y:Number, z:Number):Agent
        {
            var made:Agent = new Agent("cube");
            made.moveTo(x, y, z);
            return made;
        }

        private static function ball(x:Number, y:Number):Agent
        {
            var made:Agent = cube(x, y, 0);
            made.shape = "sphere";
            return made;
        }

        // Cubes below z = 0.
        private function floor(length:int, side:int):void
        {
            for (var i:int = -2; i < length; i++)
            {
                for (var k:int = -side; k <= side + 4; k++)
                {
                    add(cube(i, k, -1));
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
            if (!isRight)
            {
                _wrong.add(_system + ", " + mover.shape + ": " + problem, [mover.x, mover.y, mover.z, "by", details].join(" "));
            }
        }

        private function expectShallow(mover:Agent):void
        {
            for each (var other:Agent in _agents)
            {
                if (other !== mover && _collider.areColliding(mover, other))
                {
                    var depth:Number = _collider.contactOf(mover, other).depth / Math.max(mover.size, other.size);
                    expect(depth <= HAIR, "deep", mover, [depth]);
                }
            }
        }

        private function expectFree(mover:Agent, isBins:Boolean):void
        {
            for each (var other:Agent in _agents)
            {
                // between two bumps there may be no room
                expect(isBins || other === mover || !_collider.areColliding(mover, other), "touches at the end", mover, []);
            }
            expectShallow(mover);
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

        // A level mesh of squares of two triangles each.
        private static function plain(count:int):Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i <= count; i++)
            {
                for (var k:int = 0; k <= count; k++)
                {
                    vertices.push(i - count / 2, k - count / 2, 0);
                    if (i < count && k < count)
                    {
                        var corner:uint = i * (count + 1) + k;
                        triangles.push(corner, corner + count + 1, corner + count + 2, corner, corner + count + 2, corner + 1);
                    }
                }
            }
            return new Model("plain", vertices, triangles, Model.AS_GIVEN);
        }
    }
}

package starlogo.queries
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.TerrainSurface;
    import support.Complaints;
    import support.EachCollider;
    import support.agentAt;
    import support.fillHeights;
    import support.landOf;

    /**
     * A capsule of height 2 walks over ramps, stairs and the ridge of a roof, and between pillars: in worlds of cubes, of one mesh and of the
     * ground, and in worlds that move and turn with all that is on them. All are made of one table of heights.
     */
    public class WalkWorldsTest
    {
        private static const CELL:Number = 0.5;
        private static const CELLS:int = 25;
        private static const LEAST:Number = -6;
        private static const RADIUS:Number = 0.3;
        private static const STEP:Number = 0.06;
        private static const WORLDS:Array = ["ground", "mesh", "cubes", "moving mesh", "moving cubes"];

        private var _wrong:Complaints = new Complaints();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _terrain:Terrain;
        private var _queries:AgentQueries;
        private var _level:Vector.<Agent>;
        private var _places:Vector.<Vector3D>;
        private var _agents:Vector.<Agent>;
        private var _walker:Agent;

        // How far the world has moved and turned.
        private var _shift:Vector3D = new Vector3D();
        private var _turn:Number = 0;
        private var _moves:Boolean = false;
        private var _walks:int = 0;
        private var _touches:int = 0;

        [After]
        public function fewWalksEndInATouch():void
        {
            assertTrue(_touches + " of " + _walks, _touches <= _walks / 500);
        }

        [Test]
        public function rampsUpAndDown():void
        {
            for each (var world:String in ["ground", "mesh", "moving mesh"])
            {
                // 40 degrees, and then 60
                build(world, false, function(x:Number, y:Number):Number
                    {
                        return Math.tan(40 * Math.PI / 180) * Math.min(2, Math.max(0, x)) + Math.tan(60 * Math.PI / 180) * Math.max(0, x - 4);
                    });
                put(-3, 0);
                go(world + ", up", 3, 0, 0.45);
                go(world + ", down", -3, 0.2, 0.45);
                go(world + ", up", 3, 0, 0.45);
                walkTowards(5.5, 0, 60);
                assertTrue(world + ": too steep " + local(), local().x < 4.4);
                go(world + ", back", -2, 0, 0.45);
            }
            _wrong.assertNone();
        }

        [Test]
        public function stairsUpAndDown():void
        {
            for each (var world:String in WORLDS)
            {
                build(world, true, function(x:Number, y:Number):Number
                    {
                        return 0.2 * Math.max(0, Math.min(6, Math.round(x / CELL)));
                    });
                put(-3, 0);
                go(world + ", up", 4.5, 1, 0.45);
                go(world + ", down", -3, -1, 0.45);
            }
            _wrong.assertNone();
        }

        [Test]
        public function theRidgeOfARoof():void
        {
            for each (var world:String in ["ground", "mesh", "moving mesh"])
            {
                build(world, false, function(x:Number, y:Number):Number
                    {
                        return Math.max(0, 2 - 0.8 * Math.abs(y));
                    });
                put(-4, 0);
                go(world + ", along", 4, 0, 0.45);
                assertTrue(world + ": on the ridge " + local(), Math.abs(local().y) < 0.01 && Math.abs(local().z - 2) < 0.01);
                go(world + ", down", 0, 3.5, 0.45);
                go(world + ", across", 0, -3.5, 0.45);
            }
            _wrong.assertNone();
        }

        [Test]
        public function betweenTwoPillars():void
        {
            for each (var world:String in WORLDS)
            {
                for each (var gap:int in [2, 1])
                {
                    build(world, true, function(x:Number, y:Number):Number
                        {
                            var row:int = Math.round(y / CELL);
                            return x == 0 && (row == -1 || row == gap) ? 3 : 0;
                        });
                    var middle:Number = CELL * (gap - 1) / 2;
                    put(-2, middle + 0.1);
                    if (gap == 2)
                    {
                        go(world + ", through", 2, middle, 0.01);
                        continue;
                    }
                    walkTowards(2, middle, 60);
                    assertTrue(world + ": does not fit " + local(), local().x < 0);
                    go(world + ", back", -2, 0, 0.01);
                }
            }
            _wrong.assertNone();
        }

        // The triangles of both decide, but against cubes, which are boxes.
        private function build(world:String, isBlocky:Boolean, heightOf:Function):void
        {
            _terrain = new Terrain(CELLS, CELLS, CELL, LEAST, LEAST);
            _terrain.isBlocky = isBlocky;
            fillHeights(_terrain, function(column:int, row:int):Number
                {
                    return heightOf(LEAST + CELL * column, LEAST + CELL * row);
                });
            var land:GreatLand = landOf(capsule(), BuiltInModel.cube());
            _walker = agentAt("capsule", 0, 0, 20);
            _walker.collideAs = Agent.CAPSULE;
            _level = new Vector.<Agent>();
            _places = new Vector.<Vector3D>();
            if (world.indexOf("mesh") >= 0)
            {
                var surface:TerrainSurface = new TerrainSurface(_terrain);
                surface.update();
                land.addModel(new Model("mesh", surface.vertices, surface.triangles, Model.AS_GIVEN));
                add("mesh", 0, 0, 0);
            }
            for (var i:int = 0; world.indexOf("cubes") >= 0 && i < CELLS * CELLS; i++)
            {
                var x:Number = LEAST + CELL * (i % CELLS);
                var y:Number = LEAST + CELL * int(i / CELLS);
                for (var z:Number = heightOf(x, y); z > -CELL; z -= CELL)
                {
                    add("cube", x, y, z - CELL);
                    _level[_level.length - 1].size = CELL;
                }
            }
            _agents = _level.concat(new <Agent>[_walker]);
            _queries = new AgentQueries(EachCollider.make(world.indexOf("cubes") >= 0 ? "tightest fits" : "triangles", land));
            _queries.terrain = world == "ground" ? _terrain : null;
            _moves = world.indexOf("moving") >= 0;
            _shift.setTo(0, 0, 0);
            _turn = 0;
            _queries.update(_agents);
        }

        private function add(shape:String, x:Number, y:Number, z:Number):void
        {
            _level.push(agentAt(shape, x, y, z, "level"));
            _places.push(new Vector3D(x, y, z));
        }

        // Moves and turns the world by a frame.
        private function moveWorld():void
        {
            if (!_moves)
            {
                return;
            }
            _shift.incrementBy(new Vector3D(0.02, -0.03, 0.01));
            _turn += 0.4;
            for (var i:int = 0; i < _level.length; i++)
            {
                var at:Vector3D = inWorld(_places[i]);
                _level[i].moveTo(at.x, at.y, at.z);
                _level[i].heading = _turn;
            }
            _queries.update(_agents);
        }

        private function inWorld(at:Vector3D):Vector3D
        {
            return turned(at, _turn).add(_shift);
        }

        // Where the walker is, as seen from the world.
        private function local():Vector3D
        {
            return turned(new Vector3D(_walker.x, _walker.y, _walker.z).subtract(_shift), -_turn);
        }

        private static function turned(at:Vector3D, degrees:Number):Vector3D
        {
            var angle:Number = degrees * Math.PI / 180;
            return new Vector3D(Math.cos(angle) * at.x - Math.sin(angle) * at.y, Math.sin(angle) * at.x + Math.cos(angle) * at.y, at.z);
        }

        // Puts the walker on the ground.
        private function put(x:Number, y:Number):void
        {
            var at:Vector3D = inWorld(new Vector3D(x, y, 6));
            _walker.moveTo(at.x, at.y, at.z);
            _queries.moved(_walker);
            _options.fall = Infinity;
            _queries.walk(_walker, 0, 0, _options, _footing);
            _options.fall = 0.5;
        }

        // Goes to a place, and complains if the walker does not arrive, or ever leaves the ground.
        private function go(message:String, x:Number, y:Number, most:Number):void
        {
            var far:Number = walkTowards(x, y, 200, message, most);
            _wrong.addIf(far > 1e-6, message + ": does not arrive", String(local()));
        }

        private function walkTowards(x:Number, y:Number, frames:int, message:String = null, most:Number = 0):Number
        {
            var far:Number = Infinity;
            for (var i:int = 0; i < frames && far > 1e-6; i++)
            {
                moveWorld();
                // without a way it is carried alone
                _queries.walk(_walker, 0, 0, _options, _footing);
                var way:Vector3D = new Vector3D(x, y).subtract(local());
                way.z = 0;
                far = way.length;
                way.scaleBy(Math.min(1, STEP / Math.max(far, 1e-9)));
                way = turned(way, _turn);
                _queries.walk(_walker, way.x, way.y, _options, _footing);
                var at:Vector3D = local();
                var over:Number = at.z - _terrain.heightAt(at.x, at.y);
                var text:String = i + " at " + at + ", " + over + ", pushed " + _footing.pushed;
                _wrong.addIf(message != null && !_footing.stands, message + ": does not stand", text);
                // on a slope it stands on its side
                _wrong.addIf(message != null && !(over > -0.01 && over < most), message + ": not on the ground", text);
                _walks++;
                _touches += _queries.touchesAny(_walker) ? 1 : 0;
                _wrong.addIf(_footing.pushed > 1e-3, message + ": overlaps", text);
            }
            return far;
        }

        // A capsule of height 2, of rings of corners.
        private static function capsule():Model
        {
            var sides:int = 12;
            var vertices:Vector.<Number> = new <Number>[0, 0, 0];
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var ring:int = 1; ring <= 8; ring++)
            {
                var angle:Number = (ring < 5 ? ring : ring - 1) / 8 * Math.PI;
                for (var side:int = 0; side < sides; side++)
                {
                    var around:Number = side / sides * 2 * Math.PI;
                    var across:Number = RADIUS * Math.sin(angle);
                    vertices.push(across * Math.cos(around), across * Math.sin(around), (ring < 5 ? RADIUS : 2 - RADIUS) - RADIUS * Math.cos(angle));
                    var here:int = 1 + (ring - 1) * sides + side;
                    var next:int = 1 + (ring - 1) * sides + (side + 1) % sides;
                    if (ring == 1)
                    {
                        triangles.push(0, next, here);
                    }
                    else
                    {
                        triangles.push(here - sides, next - sides, next, here - sides, next, here);
                    }
                    if (ring == 8)
                    {
                        triangles.push(here, next, 1 + 8 * sides);
                    }
                }
            }
            vertices.push(0, 0, 2);
            return new Model("capsule", vertices, triangles, Model.AS_GIVEN);
        }
    }
}

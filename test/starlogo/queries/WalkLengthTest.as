package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.agentAt;
    import support.fillHeights;
    import support.landOf;

    /** No walk goes farther on the ground plane than it is asked to: over rough ground, valleys, columns and turned cubes. */
    public class WalkLengthTest
    {
        // Rounding, as a part of the way; and the gaps that a walk leaves, as a part of the extent.
        private static const ROUNDING:Number = 1e-9;
        private static const GAPS:Number = 1e-9;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _random:SeededRandom = new SeededRandom(4703);
        private var _wrong:Complaints = new Complaints();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();
        private var _terrain:Terrain;
        private var _queries:AgentQueries;
        private var _walker:Agent;

        // The walks, those that came all the way, and those that fell.
        private var _walks:int = 0;
        private var _whole:int = 0;
        private var _falls:int = 0;

        [Test]
        public function aWalkIsNeverLongerThanItsWay():void
        {
            _options.fall = 0;
            walkInWorlds(false);
            walkInWorlds(true);
            assertTrue(String([_walks, _whole]), _walks > 400 && _whole > 0.3 * _walks && _whole < 0.95 * _walks);
        }

        [Test]
        public function aFallGoesAtMostHalfAsFarSideways():void
        {
            _options.fall = 0.5;
            walkInWorlds(false);
            walkInWorlds(true);
            assertTrue(String([_walks, _falls]), _walks > 400 && _falls > 0.02 * _walks && _falls < 0.5 * _walks);
        }

        // On the edge of a low column the ground's normal is tilted. The plane of such a place would lead a long walk over any wall.
        [Test]
        public function aLongWalkGoesOverNoWall():void
        {
            _options.fall = Infinity;
            var far:int = 0;
            for each (var name:String in EachCollider.NAMES)
            {
                for (var world:int = 0; world < Effort.choose(4, 40, 1); world++)
                {
                    _terrain = new Terrain(21, 21, 1, -10, -10);
                    _terrain.isBlocky = world % 2 == 0;
                    fillHeights(_terrain, function(column:int, row:int):Number
                        {
                            return Math.max(Math.abs(column - 10), Math.abs(row - 10)) == 8 ? 4 : _random.between(-0.1, 0.1);
                        });
                    _queries = new AgentQueries(EachCollider.make(name, _greatLand));
                    _queries.terrain = _terrain;
                    _queries.update(new <Agent>[]);
                    _walker = agentAt(_random.pick(["sphere", "cube", "cylinder"]), 0, 0, 0.2);
                    for (var k:int = 0; k < Effort.choose(20, 20, 2); k++)
                    {
                        var angle:Number = _random.between(0, 2 * Math.PI);
                        var way:Number = _random.between(1, 40);
                        _queries.walk(_walker, way * Math.cos(angle), way * Math.sin(angle), _options, _footing);
                        var message:String = name + " " + world + ", walk " + k + " of " + way + ": " + [_walker.x, _walker.y, _walker.z];
                        assertTrue(message, Math.abs(_walker.x) < 8 && Math.abs(_walker.y) < 8 && _walker.z < 3.5);
                        far += Math.max(Math.abs(_walker.x), Math.abs(_walker.y)) > 5 ? 1 : 0;
                    }
                }
            }
            assertTrue("at the wall: " + far, far > 2);
        }

        [Test]
        public function whatIsSteepMakesNoWayLongerIfItIsNotTooSteep():void
        {
            _options.slopeDegrees = 89;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for (var world:int = 0; world < Effort.choose(6, 100, 1); world++)
                {
                    makeWorld(name, world, false);
                    _options.slopeDegrees = 89;
                    _options.stepHeight = _options.snap = 1.5;
                    walkAbout(name, 40, 0);
                }
            }
            _wrong.assertNone();
            // it falls off heaps of cubes that are higher than it steps
            assertTrue(String([_walks, _whole, _falls]), _walks > 200 && _whole > 0.3 * _walks && _falls <= 0.001 * _walks);
        }

        [Test]
        public function whatIsInTheWayOfASlideDownStopsIt():void
        {
            _options.fall = 0.5;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var slope:Terrain = new Terrain(9, 9, 1, -4, -4);
                fillHeights(slope, function(column:int, row:int):Number
                    {
                        return -2 * column;
                    });
                var walker:Agent = agentAt("sphere", 0, 0.1, -7.5);
                walker.size = 0.5;
                var rock:Agent = agentAt("cube", 2.3, 0.1, -9.5);
                rock.size = 4;
                rock.hierarchical = true;
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                queries.terrain = slope;
                queries.update(new <Agent>[walker, rock]);
                for (var i:int = 0; i < 5; i++)
                {
                    queries.walk(walker, 0, 0, _options, _footing);
                    assertFalse(name + ": " + [i, walker.x, walker.z], queries.touchesAny(walker));
                }
                assertTrue(name + ": " + walker.x, walker.x > 0.04 && walker.x < 0.06);
            }
        }

        private function walkInWorlds(isBlocky:Boolean):void
        {
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                for (var world:int = 0; world < Effort.choose(12, 200, 1); world++)
                {
                    makeWorld(name, world, isBlocky);
                    walkAbout(name + (isBlocky ? ", columns" : ", slopes"), 40, _options.fall / 2);
                }
            }
            _wrong.assertNone();
        }

        private function makeWorld(name:String, world:int, isBlocky:Boolean):void
        {
            _terrain = new Terrain(24, 24, 1, -12, -12);
            _terrain.isBlocky = isBlocky;
            var rough:Number = _random.pick([0.3, 0.6, 1]);
            fillHeights(_terrain, function(column:int, row:int):Number
                {
                    return _random.between(-rough, rough);
                });
            _options.slopeDegrees = _random.pick([30, 45, 60]);
            _options.stepHeight = _random.pick([0, 0.1, 0.25, 0.5]);
            _options.snap = _random.pick([0.1, 0.25, 0.5]);
            _walker = agentAt(["sphere", "cube", "cylinder"][world % 3], 0, 0, 20);
            _walker.size = _random.pick([0.2, 0.5, 1.2]);
            _walker.heading = _random.between(0, 360);
            var agents:Vector.<Agent> = new <Agent>[_walker];
            for (var i:int = 0; i < 40 && world % 2 == 0; i++)
            {
                var cube:Agent = agentAt("cube", _random.between(-10, 10), _random.between(-10, 10), _random.between(-1, 0.5), "rocks");
                cube.heading = _random.between(0, 360);
                cube.pitch = _random.between(-40, 40);
                cube.hierarchical = true;
                agents.push(cube);
            }
            _queries = new AgentQueries(EachCollider.make(name, _greatLand));
            _queries.terrain = _terrain;
            _queries.update(agents);
            _queries.moveUntilTouch(_walker, 0, 0, -40);
        }

        private function walkAbout(name:String, steps:int, sideways:Number):void
        {
            for (var i:int = 0; i < steps; i++)
            {
                if (Math.abs(_walker.x) > 10 || Math.abs(_walker.y) > 10)
                {
                    _walker.moveTo(-0.9 * _walker.x, -0.9 * _walker.y, 20);
                    _queries.moved(_walker);
                    _queries.moveUntilTouch(_walker, 0, 0, -40);
                }
                walk(name, sideways);
                if (!_footing.stands)
                {
                    _falls++;
                    _queries.moveUntilTouch(_walker, 0, 0, -0.1);
                }
            }
        }

        private function walk(name:String, sideways:Number):void
        {
            var way:Number = _random.pick([0, 0.05, 0.1, 0.3]);
            var turn:Number = _random.between(0, 7);
            var x:Number = _walker.x;
            var y:Number = _walker.y;
            var z:Number = _walker.z;
            _queries.walk(_walker, way * Math.cos(turn), way * Math.sin(turn), _options, _footing);
            var goneX:Number = _walker.x - x;
            var goneY:Number = _walker.y - y;
            var gone:Number = Math.sqrt(goneX * goneX + goneY * goneY);
            var message:String = [x, y, z].join() + " to " + [_walker.x, _walker.y, _walker.z] + " " + gone + " of " + way + " " + _footing.part;
            _walks++;
            _whole += way > 0 && _footing.part > 1 - ROUNDING ? 1 : 0;
            _wrong.addIf(gone > (way + sideways) * (1 + ROUNDING) + GAPS * _walker.size, name + ": too far", message);
            _wrong.addIf(sideways == 0 && Math.abs(_footing.part * way - gone) > ROUNDING * way + GAPS * _walker.size, name + ": another part", message);
        }
    }
}

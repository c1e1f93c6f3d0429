package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.Complaints;
    import support.Effort;
    import support.EachCollider;
    import support.agentAt;
    import support.landOf;

    /** Capsules of many sizes walk on floors that are far larger, under a far larger sky, and far from the origin. */
    public class WalkScalesTest
    {
        private static const NAMES:Array = ["tightest fits", "triangles", "combinations, exact"];

        private var _land:GreatLand = landOf(BuiltInModel.capsule(0.25, 1, "hero"), BuiltInModel.box(1, 1, 1));
        private var _random:SeededRandom = new SeededRandom(5204);
        private var _wrong:Complaints = new Complaints();
        private var _options:WalkOptions = new WalkOptions();
        private var _footing:Footing = new Footing();

        // The size of the walker, of its floor and of a box above it, and where it begins. A size of 0 is for none.
        private var _size:Number;
        private var _floorSize:Number;
        private var _skySize:Number;
        private var _x:Number;
        private var _y:Number;

        [Test]
        public function aStepIsClimbedAndARampToo():void
        {
            for (var i:int = Effort.choose(60, 2000); i > 0; i--)
            {
                chooseSizes();
                walkTo(0.2, 0);
                walkTo(0, _random.between(5, 40));
            }
            _wrong.assertNone();
        }

        [Test]
        public function knownSizesTooAreNoObstacle():void
        {
            for each (var sizes:Array in [[1, 1e4, 0, 0], [1, 3e4, 0, 0], [1, 1e6, 0, 0], [1, 20, 2e5, 0], [0.01, 0.2, 0, 1e6], [1, 20, 0, 1e8]])
            {
                _size = sizes[0];
                _floorSize = sizes[1];
                _skySize = sizes[2];
                _x = _y = sizes[3];
                walkTo(0.2, 0);
                walkTo(0, 20);
            }
            _wrong.assertNone();
        }

        /** A walker that stands a clearance above a floor stands there, and is carried, however little its options let it reach. */
        [Test]
        public function anIdleWalkerStandsWithoutSnapAndFall():void
        {
            for each (var floorSize:Number in [1, 100, 1e4, 1e6])
            {
                for each (var size:Number in [0.1, 1])
                {
                    for each (var fall:Number in [0, 1e-10])
                    {
                        var floor:Agent = agentAt("box", 0, 0, -floorSize);
                        var walker:Agent = agentAt("box", 0, 0, 0.01);
                        floor.size = floorSize;
                        walker.size = size;
                        var queries:AgentQueries = new AgentQueries(EachCollider.make(_random.pick(NAMES), _land));
                        queries.update(new <Agent>[floor, walker]);
                        _options.fall = 1;
                        queries.walk(walker, 0, 0, _options, _footing);
                        _options.fall = _options.snap = fall;
                        for (var i:int = 1; i < 4; i++)
                        {
                            queries.walk(walker, 0, 0, _options, _footing);
                            _wrong.addIf(!_footing.stands, "falls", [floorSize, size, fall, i].join());
                            floor.moveTo(0.1 * i, 0, -floorSize);
                            queries.update(new <Agent>[floor, walker]);
                        }
                        queries.walk(walker, 0, 0, _options, _footing);
                        _wrong.addIf(Math.abs(walker.x - 0.3) > 1e-6, "is not carried", [floorSize, size, fall, walker.x].join());
                    }
                }
            }
            _wrong.assertNone();
        }

        /** Ground is close to an agent by what is near, and not by something large that is far away. */
        [Test]
        public function aLargeAgentFarAwayBringsNoGroundNearer():void
        {
            for each (var name:String in NAMES)
            {
                var walker:Agent = agentAt("box", 0, 0, 1 + 5e-7);
                var large:Agent = agentAt("box", 0, 3e6, 0);
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
                walker.size = 0.01;
                large.size = 1e6;
                _options.snap = _options.fall = 0;
                queries.update(new <Agent>[agentAt("box", 0, 0, 0), large, walker]);
                assertTrue(name, !queries.walk(walker, 0, 0, _options, _footing).stands);
            }
        }

        // Sizes and places that differ by orders of magnitude. Coordinates keep eight digits of the walker.
        private function chooseSizes():void
        {
            _size = Math.pow(10, _random.between(-3, 2));
            _floorSize = Math.min(1e6, _size * Math.pow(10, _random.between(1.5, 6)));
            _skySize = _random.chance(0.5) ? 0 : Math.min(1e6, _size * Math.pow(10, _random.between(1, 6)));
            _x = _random.chance(0.5) ? 0 : Math.min(1e8, _size * Math.pow(10, _random.between(0, 8)));
            _y = _random.chance(0.5) ? 0 : -_x;
        }

        // Walks a way of four sizes: over a step of this part of the size at half of it, or up a slope of these degrees.
        private function walkTo(step:Number, slope:Number):void
        {
            var floor:Agent = agentAt("box", _x, _y, 0, "level");
            floor.size = _floorSize;
            floor.pitch = -slope;
            // the middle of its upper side is where the walker begins
            floor.moveTo(_x + _floorSize * Math.sin(slope / 180 * Math.PI), _y, -_floorSize * Math.cos(slope / 180 * Math.PI));
            var walker:Agent = agentAt("hero", _x, _y, 0.1 * _size);
            walker.size = _size;
            walker.collideAs = Agent.CAPSULE;
            var agents:Vector.<Agent> = new <Agent>[floor, walker];
            if (step > 0)
            {
                var box:Agent = agentAt("box", _x + 4 * _size, _y, (step - 4) * _size, "level");
                box.size = 4 * _size;
                agents.push(box);
            }
            if (_skySize > 0)
            {
                var sky:Agent = agentAt("box", _x, _y, (1.5 + 4 * Math.tan(slope / 180 * Math.PI)) * _size, "level");
                sky.size = _skySize;
                agents.push(sky);
            }
            _options.stepHeight = _options.snap = 0.25 * _size;
            _options.fall = 0.5 * _size;
            var name:String = _random.pick(NAMES);
            var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _land));
            queries.update(agents);
            queries.walk(walker, 0, 0, _options, _footing);
            for (var i:int = 0; i < 40; i++)
            {
                queries.walk(walker, 0.1 * _size, 0, _options, _footing);
                _wrong.addIf(!_footing.stands || _footing.part < 0.9, name + ", slope " + slope, [_size, _floorSize, _skySize, _x, _y, i, _footing].join());
            }
            _wrong.addIf(Math.abs(walker.x - _x - 4 * _size) > 0.5 * _size, name + ", slope " + slope + ": does not arrive",
                    [_size, _floorSize, _skySize, _x, _y, (walker.x - _x) / _size, walker.z / _size].join());
        }
    }
}

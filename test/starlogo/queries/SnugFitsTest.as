package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.CombinationCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.FrameByFrame;
    import support.SolidModels;
    import support.agentAt;
    import support.landOf;

    /**
     * Movers with an opening exactly as wide as something else, openings without width, and walls without thickness: nothing ever goes through. With a
     * millionth of room the way is free.
     */
    public class SnugFitsTest
    {
        private static const SYSTEMS:Array = ["hierarchies", "triangles", "combinations", "combinations, exact"];

        // More than the tolerances of a motion of agents of size 3.
        private static const HAIR:Number = 1e-8;

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(4906);
        private var _wrong:Complaints = new Complaints();

        // The world under way.
        private var _agents:Vector.<Agent>;
        private var _queries:AgentQueries;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(BuiltInModel.cube(), BuiltInModel.sphere());
            sGreatLand.addModel(SolidModels.of("u", [[1, -1, 0, 0, false], [1, 1, 0, 0, false], [1, -1, -1, 0, false], [1, 0, -1, 0, false],
                            [1, 1, -1, 0, false]], Model.AS_GIVEN));
            sGreatLand.addModel(sheet("sheet", 1));
            sGreatLand.addModel(sheet("large sheet", 3));
        }

        [Test(async, timeout="3600000")]
        public function aUAroundAPostNeverGoesThroughIt():void
        {
            FrameByFrame.repeat(this, Effort.choose(480, 24000), function(i:int):void
                {
                    var system:String = SYSTEMS[i % 4];
                    var heading:Number = [0, 30, 90][i % 3];
                    var u:Agent = aroundAPost(system, heading, 1);
                    go(u, _random.pick([-2, -0.3, 0, 0.3, 2]), _random.pick([-2, -0.3, 0, 0.3, 2]), _random.pick([0, 0, -0.4, 0.4]));
                    expectAround(system, heading, u, HAIR);
                }, _wrong.assertNone);
        }

        [Test(async, timeout="3600000")]
        public function aUAroundAColumnOfTheGroundNeverGoesThroughIt():void
        {
            var terrain:Terrain = new Terrain(9, 9, 1, -4, -4);
            terrain.isBlocky = true;
            terrain.setHeight(4, 4, 1.5);
            FrameByFrame.repeat(this, Effort.choose(160, 8000), function(i:int):void
                {
                    var system:String = SYSTEMS[i % 4];
                    var u:Agent = agentAt("u", 0, 0, _random.pick([0.1, 0.25, 1e-6]));
                    u.hierarchical = true;
                    _queries = new AgentQueries(EachCollider.make(system, sGreatLand));
                    _queries.terrain = terrain;
                    _queries.update(new <Agent>[u]);
                    go(u, _random.pick([-2, -0.3, 0, 0.3, 2]), _random.pick([-2, -0.3, 0, 0.3, 2]), _random.pick([0, 0.2]));
                    _wrong.addIf(Math.abs(u.x) > HAIR || u.y > HAIR, system, u.x + ", " + u.y);
                }, _wrong.assertNone);
        }

        [Test]
        public function withAMillionthOfRoomItLeavesAndComesBack():void
        {
            for each (var system:String in SYSTEMS)
            {
                for each (var heading:Number in [0, 30, 90])
                {
                    // the room is on either side, and before the base
                    var u:Agent = aroundAPost(system, heading, 1 - 2e-6);
                    var x:Number = Math.sin(heading * Math.PI / 180);
                    var y:Number = -Math.cos(heading * Math.PI / 180);
                    expect(_queries.moveUntilTouch(u, 3 * x, 3 * y, 0) == 1, system, heading, "does not leave", u);
                    var back:Number = 3 * _queries.moveUntilTouch(u, -3 * x, -3 * y, 0);
                    expect(back > 2.99 && back <= 3 + 3e-6, system, heading, "does not come back", u);
                    for (var i:int = 0; i < 20; i++)
                    {
                        go(u, _random.between(-2, 2), 0, 0);
                        expectAround(system, heading, u, 3e-6);
                        u.moveTo(0, 0, 0);
                        _queries.moved(u);
                    }
                }
            }
            _wrong.assertNone();
        }

        // Between two cubes that touch there is no room, and between two that are apart there is.
        [Test]
        public function aSheetStopsBeforeASlotWithoutWidth():void
        {
            for each (var system:String in SYSTEMS)
            {
                for each (var width:Number in [0, 1e-6])
                {
                    for each (var slides:Boolean in [false, true])
                    {
                        var mover:Agent = agentAt("sheet", -3, 0, 0.5);
                        beginWith(system, mover, agentAt("cube", 0, (1 + width) / 2, 0), agentAt("cube", 0, -(1 + width) / 2, 0));
                        var part:Number = slides ? _queries.slide(mover, 6, 0, 0) : _queries.moveUntilTouch(mover, 6, 0, 0);
                        expect(width == 0 ? mover.x < -1 + HAIR : part == 1, system, width, "part " + part, mover);
                        // in its own slot it never leaves it sideways
                        mover.moveTo(0, 0, 0.5);
                        _queries.moved(mover);
                        go(mover, _random.pick([0, 0.3]), _random.pick([-2, -0.3, 0.3, 2]), 0);
                        expect(Math.abs(mover.y) <= width + HAIR || Math.abs(mover.x) > 1 - HAIR, system, width, "through", mover);
                    }
                }
            }
            _wrong.assertNone();
        }

        // Floor and ceiling are one tree, and the ball is higher than the room between them. No number of short motions leads it into the floor.
        [Test]
        public function aBallInASlotThatIsTooLowStaysThere():void
        {
            for each (var overlap:Number in [1e-8, 1e-7])
            {
                var top:Number = 1 - 2 * overlap;
                var corners:Vector.<Number> = new <Number>[-50, -50, 0, 50, -50, 0, 50, 50, 0, -50, 50, 0, -50, -50, top, 50, -50, top, 50, 50, top,
                        -50, 50, top];
                var slot:Agent = new Agent("slot");
                slot.hierarchical = true;
                var collider:CombinationCollider = new CombinationCollider(landOf(BuiltInModel.sphere(),
                            new Model("slot", corners, new <uint>[0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7], Model.AS_GIVEN)));
                collider.exact = true;
                var queries:AgentQueries = new AgentQueries(collider);
                var ball:Agent = agentAt("sphere", 0, 0, -overlap);
                queries.update(new <Agent>[slot, ball]);
                for (var i:int = 0; i < 40; i++)
                {
                    var step:Number = _random.pick([1e-6, 1e-5, 9e-5]);
                    if (i % 2 == 0)
                    {
                        queries.moveUntilTouch(ball, 0, 0, -step);
                    }
                    else
                    {
                        queries.slide(ball, 0, 0, -step);
                    }
                    _wrong.addIf(!(ball.z > -4 * overlap), "into the floor, overlap " + overlap, "call " + i + ", step " + step + ": " + ball.z);
                }
                queries.slide(ball, 2, 0, 0);
                _wrong.addIf(Math.abs(ball.x - 2) > 1e-6, "stuck, overlap " + overlap, String(ball.x));
            }
            _wrong.assertNone();
        }

        [Test]
        public function nothingGetsThroughASheet():void
        {
            var stopped:int = 0;
            for each (var system:String in EachCollider.ALL_NAMES.slice(1))
            {
                for each (var heading:Number in [0, 30, 90])
                {
                    for each (var pitch:Number in [0, 17, 90])
                    {
                        for each (var shape:String in ["cube", "sphere", "sheet"])
                        {
                            stopped += push(system, shape, heading, pitch);
                        }
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(stopped + " stopped", stopped > 2000);
        }

        // Pushes an agent to and fro on one side of a sheet. Returns how often the sheet stopped it.
        private function push(system:String, shape:String, heading:Number, pitch:Number):int
        {
            var wall:Agent = agentAt("large sheet", 0, 0, 0);
            wall.heading = heading;
            wall.pitch = pitch;
            // the normal of the sheet, which is across y before it is turned about y, and then about z
            var x:Number = -Math.sin(heading * Math.PI / 180);
            var y:Number = Math.cos(heading * Math.PI / 180);
            var mover:Agent = agentAt(shape, -1.5 * x, -1.5 * y, 0);
            mover.size = 0.5;
            mover.heading = _random.pick([heading, 10]);
            beginWith(system, wall, mover);
            var stopped:int = 0;
            for (var i:int = 0; i < Effort.choose(55, 1000); i++)
            {
                var far:Number = _random.pick([1e-9, 1e-3, 0.3, 1.5]);
                var part:Number = go(mover, far * (x + _random.between(-0.5, 0.5)), far * (y + _random.between(-0.5, 0.5)), far * _random.between(-0.3, 0.3));
                stopped += part < 1 ? 1 : 0;
                var side:Number = x * mover.x + y * mover.y;
                expect(side < HAIR, system + ", " + shape, heading + ", " + pitch, "through by " + side, mover);
                if (Math.abs(mover.x) + Math.abs(mover.y) + Math.abs(mover.z) > 0.7 || _random.between(0, 1) < 0.1)
                {
                    // it must not get around it
                    mover.moveTo(-_random.between(0.4, 0.7) * x, -_random.between(0.4, 0.7) * y, 0);
                    _queries.moved(mover);
                }
            }
            return stopped;
        }

        // A U whose opening is at y > 0 before it is turned, with a post in it.
        private function aroundAPost(system:String, heading:Number, size:Number):Agent
        {
            var u:Agent = agentAt("u", 0, 0, 0);
            u.heading = heading;
            var post:Agent = agentAt("cube", 0, 0, (1 - size) / 2);
            post.heading = heading;
            post.size = size;
            beginWith(system, u, post);
            return u;
        }

        private function beginWith(system:String, ...agents):void
        {
            _agents = new Vector.<Agent>();
            for each (var agent:Agent in agents)
            {
                agent.hierarchical = true;
                _agents.push(agent);
            }
            _queries = new AgentQueries(EachCollider.make(system, sGreatLand));
            _queries.update(_agents);
        }

        private function go(mover:Agent, x:Number, y:Number, z:Number):Number
        {
            return _random.chance() ? _queries.slide(mover, x, y, z) : _queries.moveUntilTouch(mover, x, y, z);
        }

        // In the U's directions, the post is between its sides, before its base, or the U has left it.
        private function expectAround(system:String, heading:Number, u:Agent, room:Number):void
        {
            var cosine:Number = Math.cos(heading * Math.PI / 180);
            var sine:Number = Math.sin(heading * Math.PI / 180);
            var aside:Number = Math.abs(cosine * u.x + sine * u.y);
            var deeper:Number = cosine * u.y - sine * u.x;
            expect(deeper <= room && (aside <= room || deeper <= -1 + room || Math.abs(u.z) >= 1 - room), system, heading, "through", u);
        }

        private function expect(isRight:Boolean, system:String, way:*, problem:String, mover:Agent):void
        {
            _wrong.addIf(!isRight, system + ", " + way + ": " + problem, [mover.x, mover.y, mover.z].join(" "));
        }

        // A square without thickness across y, with its middle at the origin.
        private static function sheet(name:String, size:Number):Model
        {
            var half:Number = size / 2;
            return new Model(name, new <Number>[-half, 0, -half, half, 0, -half, half, 0, half, -half, 0, half], new <uint>[0, 1, 2, 0, 2, 3], Model.AS_GIVEN);
        }
    }
}

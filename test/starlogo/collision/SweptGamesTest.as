package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Effort;
    import support.Fixtures;
    import support.SolidModels;
    import support.landOf;

    /**
     * Random games against brute force that looks at every pair at 65 moments of each frame, standing still: nothing that it sees is
     * missed, nor found too late, and what is found stands touching at its time.
     */
    public class SweptGamesTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const MOMENTS:int = 64;
        private static const FRAMES:int = 60;
        private static const SHORTLY:Number = 1e-7;

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom;
        private var _agents:Vector.<Agent>;

        // Each agent's double, which brute force moves, and where the agent was in the frame before: x, y, z, or NaN.
        private var _doubles:Vector.<Agent>;
        private var _last:Vector.<Number>;

        private var _brute:Collider;
        private var _seen:int;
        private var _found:int;
        private var _glimpses:int;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(), SolidModels.apart(),
                    new ObjModel("bear", Fixtures.text(FIXTURES[0])));
        }

        [Test]
        public function missNothingThatBruteForceSees():void
        {
            play("bins", 501, Effort.choose(2, 250), 6);
            play("tightest fits", 502, Effort.choose(2, 400), 6);
            play("hierarchies", 503, Effort.choose(1, 100), 4);
            play("triangles", 504, Effort.choose(1, 100), 4);
            play("combinations", 505, Effort.choose(1, 150), 5);
        }

        private function play(name:String, seed:int, games:int, count:int):void
        {
            var collider:Collider = EachCollider.make(name, sGreatLand);
            _random = new SeededRandom(seed);
            _brute = EachCollider.make(name, sGreatLand);
            _seen = _found = _glimpses = 0;
            for (var game:int = 0; game < games; game++)
            {
                makeAgents(count);
                for (var frame:int = 0; frame < FRAMES; frame++)
                {
                    move();
                    check(name + ", game " + game + ", frame " + frame, collider);
                }
            }
            trace("  " + name + ": " + games + " games, brute force saw " + _seen + " pairs, none missed; " + _found + " found, "
                    + _glimpses + " of them between two of its moments");
            assertTrue(name + ", seen: " + _seen, _seen > 8 * games && _found < 0.7 * games * FRAMES * count * (count - 1) / 2);
        }

        private function makeAgents(count:int):void
        {
            _agents = new Vector.<Agent>();
            _doubles = new Vector.<Agent>();
            _last = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(_random.pick(["sphere", "cube", "cylinder", "apart", "bear"]));
                agent.sweeps = _random.chance(0.5);
                agent.size = _random.logBetween(0.3, 3);
                agent.hierarchical = _random.chance(0.5);
                agent.traversalDepth = _random.integer(0, 6);
                agent.moveTo(_random.between(-5, 5), _random.between(-5, 5), _random.between(-1, 1));
                _agents.push(agent);
                var twin:Agent = new Agent(agent.shape);
                _doubles.push(twin);
                _last.push(NaN, NaN, NaN);
            }
        }

        private function move():void
        {
            for (var i:int = 0; i < _agents.length; i++)
            {
                var agent:Agent = _agents[i];
                var speed:Number = _random.pick([0, 0.1, 1, 5]);
                var x:Number = agent.x * 0.4 + speed * _random.normal();
                var y:Number = agent.y * 0.4 + speed * _random.normal();
                var z:Number = agent.z * 0.4 + 0.1 * speed * _random.normal();
                if (_random.chance(0.05))
                {
                    agent.jumpTo(x, y, z);
                    _last[3 * i] = NaN;
                }
                else if (_random.chance(0.95))
                {
                    agent.moveTo(x, y, z);
                }
                if (_random.chance(0.2))
                {
                    agent.heading = _random.between(0, 360);
                    agent.pitch = _random.chance(0.5) ? 0 : _random.between(0, 360);
                }
                if (_random.chance(0.02))
                {
                    agent.shape = agent.shape == "sphere" ? "cube" : "sphere";
                    _last[3 * i] = NaN;
                }
            }
        }

        private function check(name:String, collider:Collider):void
        {
            var found:Vector.<Agent> = collider.findCollisions(_agents);
            var times:Object = {};
            var contact:Contact = new Contact();
            var latest:Number = 0;
            for (var k:int = 0; k < found.length; k += 2)
            {
                collider.contactOf(found[k], found[k + 1], contact);
                assertTrue(name + ": times in order", contact.time >= latest);
                latest = contact.time;
                checkContact(name + ": " + found[k] + " and " + found[k + 1], contact, found[k]);
                times[found[k].id + " " + found[k + 1].id] = contact.time;
                _found++;
            }
            for (var i:int = 0; i < _agents.length; i++)
            {
                copyTraits(_agents[i], _doubles[i]);
            }
            for (i = 0; i < _agents.length; i++)
            {
                for (var j:int = i + 1; j < _agents.length; j++)
                {
                    checkPair(name + ": " + _agents[i] + " and " + _agents[j], i, j, times[_agents[i].id + " " + _agents[j].id]);
                }
            }
            for (i = 0; i < _agents.length; i++)
            {
                _last[3 * i] = _agents[i].x;
                _last[3 * i + 1] = _agents[i].y;
                _last[3 * i + 2] = _agents[i].z;
            }
        }

        private function checkContact(name:String, contact:Contact, collider:Agent):void
        {
            assertTrue(name + ": normal " + contact.normal, Math.abs(contact.normal.length - 1) < 1e-9);
            // a first touch is none that goes deep
            assertTrue(name + ": depth " + contact.depth, contact.depth >= 0 && (contact.time == 0 || contact.time == 1 || contact.depth < 1e-6));
            var i:int = _agents.indexOf(collider);
            var back:Number = isNaN(_last[3 * i]) ? 0 : 1 - contact.time;
            var x:Number = contact.point.x - collider.x + back * (collider.x - _last[3 * i] || 0);
            var y:Number = contact.point.y - collider.y + back * (collider.y - _last[3 * i + 1] || 0);
            var z:Number = contact.point.z - collider.z + back * (collider.z - _last[3 * i + 2] || 0);
            assertTrue(name + ": point " + [x, y, z], Math.sqrt(x * x + y * y + z * z) < 4 * collider.size);
        }

        // The time is undefined if the pair was not found.
        private function checkPair(name:String, i:int, j:int, time:*):void
        {
            var isSwept:Boolean = (isSweeping(i) || isSweeping(j)) && (hasMoved(i) || hasMoved(j));
            var isSeen:Boolean = false;
            for (var k:int = isSwept ? 0 : MOMENTS; k <= MOMENTS && !isSeen; k++)
            {
                isSeen = collideAt(i, j, k / MOMENTS);
                if (isSeen)
                {
                    _seen++;
                    assertTrue(name + " are missed", time !== undefined);
                    assertTrue(name + " meet at " + k / MOMENTS + ", not " + time, time <= k / MOMENTS + SHORTLY);
                }
            }
            if (time === undefined)
            {
                return;
            }
            if (!isSwept)
            {
                assertEquals(name + " stand", 1, time);
                assertTrue(name + " do not touch", isSeen);
                return;
            }
            _glimpses += isSeen ? 0 : 1;
            assertTrue(name + " do not touch at " + time, collideAt(i, j, time) || collideAt(i, j, Math.min(1, time + SHORTLY)));
        }

        private function isSweeping(i:int):Boolean
        {
            return _agents[i].sweeps && !isNaN(_last[3 * i]);
        }

        private function hasMoved(i:int):Boolean
        {
            var agent:Agent = _agents[i];
            return !isNaN(_last[3 * i]) && (agent.x != _last[3 * i] || agent.y != _last[3 * i + 1] || agent.z != _last[3 * i + 2]);
        }

        private function collideAt(i:int, j:int, time:Number):Boolean
        {
            place(i, time);
            place(j, time);
            return _brute.areColliding(_doubles[i], _doubles[j]);
        }

        private function place(i:int, time:Number):void
        {
            var agent:Agent = _agents[i];
            var back:Number = isNaN(_last[3 * i]) ? 0 : 1 - time;
            _doubles[i].moveTo(agent.x - back * (agent.x - _last[3 * i] || 0), agent.y - back * (agent.y - _last[3 * i + 1] || 0),
                    agent.z - back * (agent.z - _last[3 * i + 2] || 0));
        }

        private static function copyTraits(from:Agent, to:Agent):void
        {
            to.shape = from.shape;
            to.size = from.size;
            to.heading = from.heading;
            to.pitch = from.pitch;
            to.hierarchical = from.hierarchical;
            to.traversalDepth = from.traversalDepth;
        }
    }
}

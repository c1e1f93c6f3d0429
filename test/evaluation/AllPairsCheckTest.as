package evaluation
{
    import evaluation.scenes.Scenes;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;

    public class AllPairsCheckTest
    {
        private static const ALL:int = int.MAX_VALUE;

        private var _agents:Vector.<Agent>;
        private var _system:FaultySystem;

        [Before]
        public function makeAgents():void
        {
            _agents = Scenes.crowd(20, "spheres").agents;
            _system = new FaultySystem(_agents.slice(0, 15));
        }

        [Test]
        public function agreesWithASystemThatIsRight():void
        {
            assertTrue(agrees(ALL));
        }

        [Test]
        public function seesAnyPairThatIsLost():void
        {
            for (var i:int = 0; i < 15; i++)
            {
                for (var j:int = i + 1; j < 15; j++)
                {
                    _system.lose(_agents[i], _agents[j]);
                    assertFalse(i + ", " + j, agrees(ALL));
                }
            }
        }

        [Test]
        public function seesAPairThatIsInvented():void
        {
            _system.invent(_agents[3], _agents[16]);
            assertFalse(agrees(ALL));
        }

        // 400 pairs, of which it may try 100: those of every fourth agent with all others
        [Test]
        public function triesEverySoManyAgentsWhereThereAreManyPairs():void
        {
            for (var i:int = 0; i < 14; i++)
            {
                _system.lose(_agents[i], _agents[i + 1]);
                assertEquals(i + ", " + (i + 1), i % 4 != 0 && i % 4 != 3, agrees(100));
            }
        }

        private function agrees(maxPairs:int):Boolean
        {
            var check:AllPairsCheck = new AllPairsCheck(_system, _agents, maxPairs);
            while (!check.work())
            {
                // a busy machine may take more than one step
            }
            return check.agrees;
        }
    }
}

import starlogo.agents.Agent;
import starlogo.collision.CollisionStatistics;
import starlogo.collision.CollisionSystem;

/** Some agents collide with one another; when it finds their pairs, one may be lost or invented. */
class FaultySystem implements CollisionSystem
{
    private var _colliding:Vector.<Agent>;
    private var _lost:Vector.<Agent>;
    private var _invented:Vector.<Agent> = new Vector.<Agent>();

    private var _statistics:CollisionStatistics = new CollisionStatistics();

    public function FaultySystem(colliding:Vector.<Agent>)
    {
        _colliding = colliding;
    }

    public function get statistics():CollisionStatistics
    {
        return _statistics;
    }

    public function lose(a:Agent, b:Agent):void
    {
        _lost = new <Agent>[a, b];
    }

    public function invent(a:Agent, b:Agent):void
    {
        _invented = new <Agent>[a, b];
    }

    public function areColliding(a:Agent, b:Agent):Boolean
    {
        return _colliding.indexOf(a) >= 0 && _colliding.indexOf(b) >= 0;
    }

    public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
    {
        out = _invented.concat();
        for (var i:int = 0; i < _colliding.length; i++)
        {
            for (var j:int = i + 1; j < _colliding.length; j++)
            {
                if (_lost == null || _lost[0] != _colliding[i] || _lost[1] != _colliding[j])
                {
                    out.push(_colliding[i], _colliding[j]);
                }
            }
        }
        return out;
    }
}

package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /**
     * With all bounding structures loaded, two agents collide when their spheres, their capsules and their tightest fits meet: on their
     * motions too, when all of them do at once.
     */
    public class SweptOuterStructuresTest
    {
        private static const PAIRS:int = 600;
        private static const MOMENTS:int = 100;
        private static const SHORTLY:Number = 1e-7;

        private var _random:SeededRandom = new SeededRandom(73);
        private var _all:GreatLand = new GreatLand();
        private var _tightest:GreatLand = new GreatLand();
        private var _standing:TightestFitCollider = new TightestFitCollider(_all);

        [Before]
        public function makeModels():void
        {
            _all.loadAllBoundingStructures = true;
            for (var i:int = 0; i < 6; i++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                while (points.length < 24)
                {
                    points.push(_random.next());
                }
                var model:Model = new Model("cloud " + i, points);
                _all.addModel(model);
                _tightest.addModel(model);
            }
        }

        [Test]
        public function collideOnTheirWaysAsTheyDoStanding():void
        {
            var seen:int = 0;
            var later:int = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                var mover:Agent = newAgent();
                var other:Agent = newAgent();
                var to:Array = [2 * _random.normal(), 2 * _random.normal(), _random.normal()];
                var from:Array = [mover.x, mover.y, mover.z];
                var expected:Number = firstSeen(mover, other, from, to);
                var time:Number = firstFound(_all, mover, other, from, to);
                assertTrue(i + ": seen at " + expected + ", found at " + time, time <= expected + SHORTLY);
                if (time <= 1)
                {
                    assertTrue(i + ": no touch at " + time, collideAt(mover, other, from, to, time) ||
                            collideAt(mover, other, from, to, Math.min(1, time + SHORTLY)));
                }
                seen += expected <= 1 ? 1 : 0;
                later += time > firstFound(_tightest, mover, other, from, to) + SHORTLY ? 1 : 0;
            }
            assertTrue("some collide: " + seen, seen > PAIRS / 10 && seen < 0.9 * PAIRS);
            assertTrue("the tightest fits alone do earlier: " + later, later > 3);
        }

        // Cubes whose faces alone count, turned: where a motion ends, and all along it.
        [Test]
        public function boxesByTheirFacesToo():void
        {
            _all.addModel(BuiltInModel.cube());
            var bySpheres:int = 0;
            for (var i:int = 0; i < 600; i++)
            {
                var mover:Agent = newAgent();
                var other:Agent = newAgent();
                mover.shape = other.shape = "cube";
                var from:Array = [mover.x, mover.y, mover.z];
                _standing.structureTests.boxFacesOnly = true;
                var isHit:Boolean = _standing.areColliding(mover, other);
                assertEquals("pair " + i + " stands", isHit, _standing.findCollisions(new <Agent>[mover, other]).length > 0);
                assertEquals("pair " + i + " sweeps without a motion", isHit, firstFound(_all, mover, other, from, from) <= 1);
                var length:Number = _random.pick([1e-6, 0.1]);
                var to:Array = [from[0] + length * _random.normal(), from[1] + length * _random.normal(), from[2] + length * _random.normal()];
                var expected:Number = firstSeen(mover, other, from, to);
                var time:Number = firstFound(_all, mover, other, from, to);
                assertTrue("pair " + i + ": seen at " + expected + ", found at " + time, time <= expected + SHORTLY);
                assertTrue("pair " + i + ": no touch at " + time, time > 1 || collideAt(mover, other, from, to, time)
                        || collideAt(mover, other, from, to, Math.min(1, time + SHORTLY)));
                _standing.structureTests.spheresFirst = false;
                bySpheres += isHit == _standing.areColliding(mover, other) ? 0 : 1;
                _standing.structureTests.spheresFirst = true;
            }
            assertTrue("the spheres decide: " + bySpheres, bySpheres > 0);
        }

        private function firstSeen(mover:Agent, other:Agent, from:Array, to:Array):Number
        {
            for (var k:int = 0; k <= MOMENTS; k++)
            {
                if (collideAt(mover, other, from, to, k / MOMENTS))
                {
                    return k / MOMENTS;
                }
            }
            return Infinity;
        }

        private function collideAt(mover:Agent, other:Agent, from:Array, to:Array, time:Number):Boolean
        {
            mover.jumpTo(from[0] + time * (to[0] - from[0]), from[1] + time * (to[1] - from[1]), from[2] + time * (to[2] - from[2]));
            return _standing.areColliding(mover, other);
        }

        private function firstFound(greatLand:GreatLand, mover:Agent, other:Agent, from:Array, to:Array):Number
        {
            var collider:TightestFitCollider = new TightestFitCollider(greatLand);
            collider.structureTests.boxFacesOnly = _standing.structureTests.boxFacesOnly;
            var agents:Vector.<Agent> = new <Agent>[mover, other];
            mover.sweeps = true;
            mover.jumpTo(from[0], from[1], from[2]);
            collider.findCollisions(agents);
            mover.moveTo(to[0], to[1], to[2]);
            var found:Vector.<Agent> = collider.findCollisions(agents);
            assertEquals(0, found.length % 2);
            return found.length == 0 ? Infinity : collider.contactOf(mover, other).time;
        }

        private function newAgent():Agent
        {
            var agent:Agent = new Agent("cloud " + _random.integer(0, 5));
            agent.moveTo(1.2 * _random.normal(), 1.2 * _random.normal(), _random.normal());
            agent.size = _random.logBetween(0.5, 2);
            agent.heading = _random.between(0, 360);
            agent.pitch = _random.between(0, 360);
            return agent;
        }
    }
}

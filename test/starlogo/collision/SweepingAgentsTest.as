package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.assertThrows;
    import support.landOf;

    /** An agent that sweeps hits everything on its path, and nothing else. */
    public class SweepingAgentsTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _ball:Agent = new Agent("sphere", "balls");
        private var _wall:Agent = new Agent("cube", "walls");
        private var _agents:Vector.<Agent> = new <Agent>[_ball, _wall];
        private var _calls:Array = [];

        [Before]
        public function makeGame():void
        {
            _ball.size = 0.2;
            _ball.sweeps = true;
            _wall.moveTo(5, 0, 0);
        }

        [Test]
        public function theOthersMotionCounts():void
        {
            for each (var collider:Collider in colliders())
            {
                // both cross the origin, at the same time or not
                for each (var start:Number in [-6, -3])
                {
                    _ball.jumpTo(-6, 0, 0.4);
                    _wall.jumpTo(0, start, 0);
                    found(collider);
                    _ball.moveTo(6, 0, 0.4);
                    _wall.moveTo(0, start + 12, 0);
                    assertEquals(collider + " from " + start, start == -6 ? 2 : 0, found(collider));
                }
                // the contact is at the same place, whichever of the two moves
                _ball.jumpTo(0, 0, 0.4);
                _wall.jumpTo(5, 0, 0);
                found(collider);
                _wall.moveTo(-5, 0, 0);
                assertEquals(collider + " runs over it", 2, found(collider));
                _wall.jumpTo(5, 0, 0);
                assertEquals(collider + " jumps over it", 0, found(collider));
                _ball.sweeps = false;
                _wall.moveTo(-5, 0, 0);
                assertEquals(collider + ": no agent sweeps", 0, found(collider));
                _ball.sweeps = true;
                _wall.jumpTo(5, 0, 0);
            }
        }

        [Test]
        public function whatHappensFirstComesFirst():void
        {
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            var walls:Array = [7, 3, 5, 9];
            _agents.length = 1;
            for each (var x:Number in walls)
            {
                var wall:Agent = new Agent("cube", "walls");
                wall.moveTo(x, 0, 0);
                _agents.push(wall);
            }
            var beside:Agent = new Agent("cube", "walls");
            beside.moveTo(9.5, 0, 0);
            _agents.push(beside);
            collision.onCollision("walls", "walls", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    _calls.push("walls " + contact.time);
                });
            collision.onCollision("balls", "walls", function(collider:Agent, collidee:Agent, contact:Contact):void
                {
                    _calls.push(collidee.x + " at " + contact.time.toFixed(3));
                });
            _ball.moveTo(0, 0, 0.4);
            collision.update(_agents);
            assertEquals("walls 1,walls 1", _calls.join());
            _calls = [];
            _ball.moveTo(10, 0, 0.4);
            collision.update(_agents);
            assertEquals("3 at 0.240,5 at 0.440,7 at 0.640,9 at 0.840,9.5 at 0.890,walls 1,walls 1", _calls.join());
        }

        [Test]
        public function whoTakesItOutStopsItThere():void
        {
            for each (var collider:Collider in colliders())
            {
                _calls = [];
                _ball.jumpTo(0, 0, 0.4);
                var behind:Agent = new Agent("cube", "walls");
                behind.moveTo(7, 0, 0);
                _agents = new <Agent>[_ball, behind, _wall];
                var collision:Collision = new Collision(collider);
                collision.onCollision("balls", "walls", function(ball:Agent, wall:Agent):void
                    {
                        _calls.push(wall.x);
                        _agents.splice(_agents.indexOf(ball), 1);
                    });
                collision.update(_agents);
                _ball.moveTo(10, 0, 0.4);
                collision.update(_agents);
                assertEquals(collider + "", "5", _calls.join());
            }
        }

        [Test]
        public function contactsAreThoseOfTheFirstTouch():void
        {
            for each (var collider:Collider in [new TightestFitCollider(_greatLand), new HierarchicalCollider(_greatLand),
                        exact(new HierarchicalCollider(_greatLand)), new CombinationCollider(_greatLand)])
            {
                _ball.shape = "cube";
                _ball.jumpTo(0, 0.1, 0.4);
                _wall.jumpTo(5, 0, 0);
                found(collider);
                _ball.moveTo(8, 0.1, 0.4);
                _wall.moveTo(5, 0, 4);
                assertEquals(collider + " passes below", 0, found(collider));
                _ball.jumpTo(0, 0.1, 0.4);
                _wall.jumpTo(6, 0, 0);
                found(collider);
                _ball.moveTo(8, 0.1, 0.4);
                _wall.moveTo(4, 0, 0);
                found(collider);
                // 5.4 apart, and 10 nearer in the end
                checkContact(collider, collider.contactOf(_ball, _wall), -1, 0.54);
                checkContact(collider, collider.contactOf(_wall, _ball), 1, 0.54);
                // whatever they do afterwards
                _ball.moveTo(80, 0, 0);
                checkContact(collider, collider.contactOf(_ball, _wall), -1, 0.54);
            }
        }

        private function checkContact(collider:Collider, contact:Contact, x:Number, time:Number):void
        {
            var name:String = collider + ": " + contact.point + ", " + contact.normal + ", " + contact.depth + " at " + contact.time;
            assertNear(name, time, contact.time);
            assertNear(name, 0, contact.depth);
            assertNear(name, x, contact.normal.x);
            // where the wall's face is at that time
            assertNear(name, 6 - 2 * time - 0.5, contact.point.x);
            assertTrue(name, Math.abs(contact.point.y - 0.1) <= 0.1 + 1e-9 && Math.abs(contact.point.z - 0.5) <= 0.1 + 1e-9);
        }

        [Test]
        public function contactsOfStandingAgents():void
        {
            _ball.sweeps = false;
            _ball.moveTo(4.45, 0, 0.4);
            for each (var collider:Collider in [new TightestFitCollider(_greatLand), new CombinationCollider(_greatLand)])
            {
                found(collider);
                var contact:Contact = collider.contactOf(_ball, _wall);
                assertEquals(1, contact.time);
                assertNear("depth", 0.05, contact.depth);
                assertNear("normal", -1, contact.normal.x);
                assertNear("point", 4.525, contact.point.x);
            }
            assertThrows(ArgumentError, /two different agents/, collider.contactOf, _ball, _ball);
            assertThrows(ArgumentError, /two agents/, collider.contactOf, null, _ball);
        }

        [Test]
        public function longWaysAreInOneCell():void
        {
            var collider:Collider = new BinCollider(_greatLand);
            _ball.jumpTo(-5000, -3000, 0);
            found(collider);
            _ball.moveTo(5000, 3000, 0);
            found(collider);
            assertEquals(1, collider.statistics.candidatePairs);
            assertEquals(1, collider.statistics.sweptPairs);
            _ball.moveTo(-5000, 0, 0);
            _wall.moveTo(5, 0, 0);
            found(collider);
            _ball.moveTo(5000, 0, 0);
            assertEquals(2, found(collider));
            assertEquals(1, collider.statistics.sweptPairs);
            assertEquals(1, collider.statistics.sphereSphereTests);
        }

        private function found(collider:Collider):int
        {
            return collider.findCollisions(_agents).length;
        }

        private function colliders():Array
        {
            return [new BinCollider(_greatLand), new TightestFitCollider(_greatLand), new HierarchicalCollider(_greatLand),
                    exact(new HierarchicalCollider(_greatLand)), new CombinationCollider(_greatLand)];
        }

        private static function exact(collider:HierarchicalCollider):HierarchicalCollider
        {
            collider.exact = true;
            return collider;
        }

        private static function assertNear(name:String, expected:Number, actual:Number):void
        {
            assertTrue(name + ": " + actual + ", not " + expected, Math.abs(actual - expected) <= 1e-9);
        }
    }
}

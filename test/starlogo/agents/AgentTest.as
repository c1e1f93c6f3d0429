package starlogo.agents
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import evaluation.pairs.SeededRandom;
    import support.assertThrows;

    public class AgentTest
    {
        [Test]
        public function hasTheClientsTraits():void
        {
            var agent:Agent = new Agent("bear");
            assertEquals("turtles", agent.breed);
            assertEquals("bear", agent.shape);
            assertEquals(1, agent.size);
            assertEquals("0 0 0 0 0 0", [agent.x, agent.y, agent.z, agent.heading, agent.pitch, agent.roll].join(" "));
            assertFalse(agent.hierarchical);
            assertEquals(0, agent.traversalDepth);
            assertTrue("ids differ", new Agent("bear").id != agent.id);
        }

        [Test]
        public function headingIsCounterClockwiseSeenFromAbove():void
        {
            var agent:Agent = new Agent("bear");
            agent.heading = 90;
            assertNear(agent, new Vector3D(1, 0, 0), 0, 1, 0);
            agent.heading = 30;
            assertNear(agent, new Vector3D(1, 0, 0), Math.sqrt(3) / 2, 0.5, 0);
        }

        [Test]
        public function transformScalesRollsPitchesHeadsAndMoves():void
        {
            var agent:Agent = new Agent("bear");
            agent.size = 2;
            agent.roll = 90;
            assertNear(agent, new Vector3D(0, 1, 0), 0, 0, 2);
            agent.pitch = 90;
            assertNear(agent, new Vector3D(0, 1, 0), 2, 0, 0);
            agent.heading = 90;
            assertNear(agent, new Vector3D(0, 1, 0), 0, 2, 0);
            agent.moveTo(10, 20, 30);
            assertNear(agent, new Vector3D(0, 1, 0), 10, 22, 30);
        }

        [Test]
        public function transformIsThePlayersOwnRotationsInThatOrder():void
        {
            var random:SeededRandom = new SeededRandom(31);
            for (var i:int = 0; i < 300; i++)
            {
                var agent:Agent = new Agent("bear");
                agent.size = random.logBetween(0.1, 10);
                agent.roll = random.between(-720, 720);
                agent.pitch = random.pick([0, 90, random.between(-720, 720)]);
                agent.heading = random.pick([0, -90, random.between(-720, 720)]);
                agent.moveTo(random.between(-50, 50), random.between(-50, 50), random.between(-50, 50));
                var expected:Matrix3D = new Matrix3D();
                expected.appendScale(agent.size, agent.size, agent.size);
                expected.appendRotation(agent.roll, Vector3D.X_AXIS);
                expected.appendRotation(agent.pitch, Vector3D.Y_AXIS);
                expected.appendRotation(agent.heading, Vector3D.Z_AXIS);
                expected.appendTranslation(agent.x, agent.y, agent.z);
                for (var k:int = 0; k < 16; k++)
                {
                    // Flash Player's matrices are in single precision
                    assertEquals("entry " + k, 0, Math.round((expected.rawData[k] - agent.transform.rawData[k]) * 1e4));
                }
            }
        }

        [Test]
        public function transformFollowsEveryChange():void
        {
            var agent:Agent = new Agent("bear");
            var first:Matrix3D = agent.transform;
            assertTrue("computed once", agent.transform === first);
            agent.x = 3;
            assertNear(agent, new Vector3D(), 3, 0, 0);
            agent.y = 4;
            assertNear(agent, new Vector3D(), 3, 4, 0);
            agent.z = 5;
            assertNear(agent, new Vector3D(), 3, 4, 5);
            agent.size = 2;
            assertNear(agent, new Vector3D(1, 0, 0), 5, 4, 5);
            agent.heading = 180;
            assertNear(agent, new Vector3D(1, 0, 0), 1, 4, 5);
            agent.heading = 0;
            assertNear(agent, new Vector3D(1, 0, 0), 5, 4, 5);
        }

        [Test]
        public function badNumbersAreNamedAndKeepTheOld():void
        {
            var agent:Agent = new Agent("bear", "bears");
            agent.moveTo(1, 2, 3);
            var traits:Array = ["x", "y", "z", "heading", "pitch", "roll"];
            for each (var trait:String in traits)
            {
                for each (var value:Number in [NaN, Infinity, -Infinity])
                {
                    assertThrows(RangeError, new RegExp("agent " + agent.id + ".*bears.*bear.*: " + trait + " .*" + value), set , agent, trait, value);
                }
            }
            for each (value in [0, -1, NaN, Infinity])
            {
                assertThrows(RangeError, new RegExp("size .*" + value), set , agent, "size", value);
            }
            assertThrows(RangeError, /y must be.*NaN/, agent.moveTo, 7, NaN, 7);
            assertThrows(RangeError, /z must be.*Infinity/, agent.moveTo, 7, 7, Infinity);
            assertThrows(RangeError, /traversalDepth/, set , agent, "traversalDepth", -1);
            assertEquals("1 2 3 1", [agent.x, agent.y, agent.z, agent.size].join(" "));
        }

        [Test]
        public function namesMustNotBeEmpty():void
        {
            assertThrows(ArgumentError, /shape.*null/, function():void
                {
                    new Agent(null);
                });
            assertThrows(ArgumentError, /breed/, function():void
                {
                    new Agent("bear", "");
                });
            var agent:Agent = new Agent("bear");
            assertThrows(ArgumentError, /shape/, set , agent, "shape", "");
            assertEquals("bear", agent.shape);
        }

        private static function set (agent:Agent, trait:String, value:*):void
        {
            agent[trait] = value;
        }

        private static function assertNear(agent:Agent, point:Vector3D, x:Number, y:Number, z:Number):void
        {
            var moved:Vector3D = agent.transform.transformVector(point);
            assertTrue(moved + " is not (" + [x, y, z] + ")", moved.subtract(new Vector3D(x, y, z)).length < 1e-5);
        }
    }
}

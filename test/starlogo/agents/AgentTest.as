package starlogo.agents
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import support.assertThrows;
    import support.create;

    use namespace engine;

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
        public function transformsAreTheCallers():void
        {
            var agent:Agent = new Agent("bear");
            agent.moveTo(1, 2, 3);
            var first:Matrix3D = agent.transform;
            agent.transform.appendScale(5, 5, 5);
            assertNear(agent, new Vector3D(), 1, 2, 3);
            agent.moveTo(4, 5, 6);
            assertEquals("as it was", 2, agent.getMatrix().position.y - 3 * first.position.x);
            assertEquals(1, first.position.x);
            var own:Matrix3D = new Matrix3D();
            assertTrue(agent.getMatrix(own) === own);
            assertEquals(4, own.position.x);
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
            assertThrows(ArgumentError, /shape.*null/, create, Agent, null);
            assertThrows(ArgumentError, /shape must be a name, not ""$/, create, Agent, "");
            assertThrows(ArgumentError, /breed/, create, Agent, "bear", "");
            var agent:Agent = new Agent("bear");
            assertThrows(ArgumentError, /shape/, set , agent, "shape", "");
            assertEquals("bear", agent.shape);
        }

        [Test]
        public function coordinatesAndSizesHaveLimits():void
        {
            var agent:Agent = new Agent("bear", "bears");
            agent.moveTo(1, 2, 3);
            for each (var trait:String in ["x", "y", "z"])
            {
                for each (var value:Number in [1.1e9, -1.1e9, 1e160, 1e308, -1e308])
                {
                    assertThrows(RangeError, new RegExp("agent " + agent.id + ".*: " + trait + " must be a finite number between -1000000000 and 1000000000"), set , agent, trait, value);
                }
            }
            assertThrows(RangeError, /: x must be.*1e\+308/, agent.moveTo, 1e308, 1e308, 0);
            assertThrows(RangeError, /: z must be.*-1e\+200/, agent.moveTo, 0, 0, -1e200);
            for each (value in [1.1e6, 1e160, 1e308, 8e307, 0.9e-6, 1e-300, Number.MIN_VALUE])
            {
                assertThrows(RangeError, new RegExp("agent " + agent.id + ".*: size must be between 0.000001 and 1000000"), set , agent, "size", value);
            }
            assertEquals("1 2 3 1", [agent.x, agent.y, agent.z, agent.size].join(" "));
            agent.moveTo(1e9, -1e9, 1e9);
            agent.size = 1e6;
            assertEquals("1000000000 -1000000000 1000000000 1000000", [agent.x, agent.y, agent.z, agent.size].join(" "));
            agent.size = 1e-6;
            assertEquals(1e-6, agent.size);
        }

        [Test]
        public function aValueThatItHasAlreadyChangesNothing():void
        {
            var agent:Agent = new Agent("bear", "bears");
            var values:Object = {shape: "bear", breed: "bears", x: 1, y: 2, z: 3, heading: 4, pitch: 5, roll: 6, size: 7, hierarchical: true, traversalDepth: 8};
            for (var trait:String in values)
            {
                agent[trait] = values[trait];
            }
            var revisions:String = agent.revision + " " + agent.bodyRevision;
            for (trait in values)
            {
                agent[trait] = values[trait];
                assertEquals(trait, revisions, agent.revision + " " + agent.bodyRevision);
            }
        }

        [Test]
        public function jumpingToWhereItIsCounts():void
        {
            // no motion leads there, so that the one before ends
            var agent:Agent = new Agent("bear");
            agent.moveTo(1, 2, 3);
            var revision:int = agent.revision;
            agent.jumpTo(1, 2, 3);
            agent.jumpTo(1, 2, 3);
            assertTrue("twice", agent.revision == revision + 2);
            assertThrows(RangeError, /z must be.*Infinity/, agent.jumpTo, 1, 2, Infinity);
            assertEquals("nowhere", revision + 2, agent.revision);
            agent.moveTo(1, 2, 3);
            assertEquals("moved to where it jumped", revision + 2, agent.revision);
        }

        [Test]
        public function everyChangeIsCounted():void
        {
            var agent:Agent = new Agent("bear", "bears");
            var moves:Object = {x: 1, y: 2, z: 3};
            var others:Object = {shape: "ball", heading: 4, pitch: 5, roll: 6, size: 7, hierarchical: true, traversalDepth: 8};
            for (var trait:String in moves)
            {
                var revision:int = agent.revision;
                var bodyRevision:int = agent.bodyRevision;
                agent[trait] = moves[trait];
                assertEquals(trait, revision + 1, agent.revision);
                assertEquals(trait, bodyRevision, agent.bodyRevision);
            }
            revision = agent.revision;
            agent.moveTo(1, 2, 4);
            assertEquals("moveTo", revision + 1, agent.revision);
            agent.jumpTo(1, 2, 5);
            assertEquals("jumpTo", revision + 2, agent.revision);
            assertEquals("moves", bodyRevision, agent.bodyRevision);
            for (trait in others)
            {
                revision = agent.revision;
                bodyRevision = agent.bodyRevision;
                agent[trait] = others[trait];
                assertEquals(trait, revision + 1, agent.revision);
                assertEquals(trait, bodyRevision + 1, agent.bodyRevision);
            }
            agent.breed = "balls";
            assertEquals("breed", new Agent("ball", "balls").breedNumber, agent.breedNumber);
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

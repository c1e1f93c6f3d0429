package starlogo.agents
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import support.assertThrows;

    use namespace engine;

    public class AgentRotationTest
    {
        [Test]
        public function aQuaternionComesBackFromWhatItTurned():void
        {
            var random:SeededRandom = new SeededRandom(2501);
            var largest:Vector.<int> = new Vector.<int>(4);
            for (var i:int = 0; i < 2000; i++)
            {
                var expected:Vector.<Number> = randomQuaternion(random);
                var length:Number = random.between(0.01, 100);
                var agent:Agent = new Agent("bear");
                agent.setQuaternion(expected[0] * length, expected[1] * length, expected[2] * length, expected[3] * length);
                var found:Vector.<Number> = agent.getQuaternion();
                var most:int = 0;
                for (var k:int = 0; k < 4; k++)
                {
                    assertNear("quaternion " + i, expected[k], found[k], 1e-15);
                    if (Math.abs(found[k]) > Math.abs(found[most]))
                    {
                        most = k;
                    }
                }
                largest[most]++;
            }
            for (k = 0; k < 4; k++)
            {
                assertTrue("component " + k + " is the largest now and then", largest[k] > 200);
            }
        }

        [Test]
        public function aQuaternionTurnsAsItSays():void
        {
            // half a turn about x and y's bisector, and a third about the diagonal
            assertRotation("1 0 0 0 1 0 0 0 1", 0, 0, 0, -3);
            assertRotation("0 1 0 1 0 0 0 0 -1", 1, 1, 0, 0);
            assertRotation("0 0 1 1 0 0 0 1 0", 1, 1, 1, 1);
        }

        [Test]
        public function itsAnglesGiveTheSameRotation():void
        {
            var random:SeededRandom = new SeededRandom(2502);
            for (var i:int = 0; i < 2000; i++)
            {
                var q:Vector.<Number> = randomQuaternion(random);
                var agent:Agent = new Agent("bear");
                agent.setQuaternion(q[0], q[1], q[2], q[3]);
                var byAngles:Agent = new Agent("bear");
                byAngles.heading = agent.heading;
                byAngles.pitch = agent.pitch;
                byAngles.roll = agent.roll;
                assertTrue(agent.pitch >= -90 && agent.pitch <= 90);
                assertTrue("angles " + i, difference(agent, byAngles) < 2e-15);
            }
        }

        [Test]
        public function nothingIsLostWhereHeadingAndRollTurnAboutTheSameAxis():void
        {
            var random:SeededRandom = new SeededRandom(2503);
            var lossByAngles:Number = 0;
            for (var i:int = 0; i < 2000; i++)
            {
                var reference:Placement = new Placement();
                var off:Number = Math.pow(10, random.between(-17, -3));
                reference.setRotation(random.between(-180, 180), i % 2 == 0 ? 90 - off : off - 90, random.between(-180, 180));
                var q:Vector.<Number> = new Vector.<Number>(4);
                reference.readQuaternion(q);
                var agent:Agent = new Agent("bear");
                agent.setQuaternion(q[0], q[1], q[2], q[3]);
                assertTrue("pole " + i, differenceOf(agent.freshPlacement(), reference) < 2e-15);
                var byAngles:Placement = new Placement();
                byAngles.setRotation(agent.heading, agent.pitch, agent.roll);
                lossByAngles = Math.max(lossByAngles, differenceOf(byAngles, reference));
            }
            assertTrue("angles still tell about where it points", lossByAngles < 1e-7);
        }

        [Test]
        public function anAngleThatIsSetMakesTheRotationOfTheThreeAgain():void
        {
            var agent:Agent = new Agent("bear");
            agent.setQuaternion(0.5, 0.5, 0.5, 0.5000001);
            var byAngles:Agent = new Agent("bear");
            byAngles.heading = agent.heading;
            byAngles.pitch = agent.pitch;
            byAngles.roll = agent.roll;
            var revision:int = agent.revision;
            agent.heading = agent.heading;
            assertEquals(revision + 1, agent.revision);
            assertEquals("to the last bit", 0, difference(agent, byAngles));
            agent.heading = agent.heading;
            assertEquals("no change", revision + 1, agent.revision);
        }

        [Test]
        public function aQuaternionIsKeptToTheBit():void
        {
            var random:SeededRandom = new SeededRandom(2507);
            for (var i:int = 0; i < 2000; i++)
            {
                var q:Vector.<Number> = randomQuaternion(random);
                // as far from length 1 as single precision makes it, and of any length
                var length:Number = random.pick([1, -1, 1 + random.between(-1e-7, 1e-7), random.between(0.1, 10)]);
                var agent:Agent = new Agent("bear");
                agent.setQuaternion(length * q[0], length * q[1], length * q[2], length * q[3]);
                var found:Vector.<Number> = agent.getQuaternion();
                for (var k:int = 0; k < 4 && Math.abs(Math.abs(length) - 1) < 1e-6; k++)
                {
                    assertEquals("taken " + i, length * q[k], found[k]);
                }
                var revision:int = agent.revision;
                agent.setQuaternion(found[0], found[1], found[2], found[3]);
                assertEquals("the same rotation " + i, revision, agent.revision);
                var other:Agent = new Agent("bear");
                other.setQuaternion(found[0], found[1], found[2], found[3]);
                assertTrue("in another agent " + i, agent.freshPlacement().hasRotationOf(other.freshPlacement()));
                assertEquals("again " + i, found.join(), agent.getQuaternion().join());
                // other turns are read from the rotation
                agent.heading += 90;
                assertTrue("turned " + i, agent.getQuaternion().join() != found.join() && agent.getQuaternion()[3] >= 0);
            }
        }

        [Test]
        public function aQuaternionMayHaveAnyLengthButZero():void
        {
            for each (var each:Number in [1.7e308, 1e200, 1e-200, 5e-324])
            {
                var agent:Agent = new Agent("bear");
                agent.setQuaternion(each, -each, each, each);
                assertEquals(String(each), "0.5,-0.5,0.5,0.5", agent.getQuaternion().join());
            }
            assertThrows(RangeError, "must not be 0", agent.setQuaternion, 0, 0, 0, 0);
        }

        [Test]
        public function anglesOfTheSameRotationStay():void
        {
            var agent:Agent = new Agent("bear");
            agent.pitch = 180;
            var before:int = agent.revision;
            agent.setQuaternion(0, 1, 0, 0);
            assertEquals(before, agent.revision);
            assertEquals(180, agent.pitch);
            agent.setQuaternion(0, 0, 0, 1);
            agent.setQuaternion(0, 1, 0, 0);
            assertTrue("angles of a quaternion: " + agent.pitch, Math.abs(agent.pitch) <= 90);
        }

        [Test]
        public function theSameQuaternionAgainIsNoChange():void
        {
            var agent:Agent = new Agent("bear");
            agent.setQuaternion(0, 0, 0, 1);
            assertEquals(0, agent.revision);
            agent.setQuaternion(0.1, 0.2, 0.3, 0.4);
            assertEquals(1, agent.revision);
            agent.setQuaternion(-0.1, -0.2, -0.3, -0.4);
            assertEquals(1, agent.revision);
            agent.heading = 30;
            agent.setQuaternion(0.1, 0.2, 0.3, 0.4);
            assertEquals(3, agent.revision);
        }

        [Test]
        public function aMatrixSetsPlaceSizeAndRotation():void
        {
            var random:SeededRandom = new SeededRandom(2504);
            for (var i:int = 0; i < 500; i++)
            {
                var from:Agent = new Agent("bear");
                from.moveTo(random.between(-50, 50), random.between(-50, 50), random.between(-50, 50));
                from.size = random.between(0.1, 10);
                from.heading = random.between(-180, 180);
                from.pitch = random.between(-180, 180);
                from.roll = random.between(-180, 180);
                var agent:Agent = new Agent("bear");
                agent.setMatrix(from.transform);
                assertNear("x " + i, from.x, agent.x, 1e-5);
                assertNear("y " + i, from.y, agent.y, 1e-5);
                assertNear("z " + i, from.z, agent.z, 1e-5);
                assertNear("size " + i, from.size, agent.size, 1e-5);
                assertTrue("rotation " + i, difference(from, agent) < 1e-6);
                var q:Vector.<Number> = agent.getQuaternion();
                assertNear("of length 1", 1, q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1e-15);
            }
            var copy:Matrix3D = agent.getMatrix();
            agent.x++;
            assertFalse("a copy", copy.rawData[12] == agent.transform.rawData[12]);
        }

        [Test]
        public function whatIsNoRotationIsRefused():void
        {
            var agent:Agent = new Agent("bear");
            agent.setQuaternion(0.1, 0.2, 0.3, 0.4);
            agent.moveTo(1, 2, 3);
            var revision:int = agent.revision;
            var refuse:Function = function(...scales):Function
            {
                return function():void
                {
                    var matrix:Matrix3D = new Matrix3D();
                    matrix.rawData = new <Number>[scales[0], 0, 0, 0, 0, scales[1], 0, 0, 0, 0, scales[2], 0, scales[3], 0, 0, 1];
                    agent.setMatrix(matrix);
                };
            };
            assertThrows(ArgumentError, /matrix/, agent.setMatrix, null);
            assertThrows(ArgumentError, /matrix must only turn/, refuse(1, 1, 1.001, 0));
            assertThrows(ArgumentError, /matrix must only turn/, refuse(1, -1, 1, 0));
            assertThrows(ArgumentError, /matrix must only turn/, refuse(0, 0, 0, 0));
            assertThrows(RangeError, /x/, refuse(1, 1, 1, Infinity));
            assertThrows(RangeError, /quaternion/, agent.setQuaternion, 0, 0, 0, 0);
            assertThrows(RangeError, /a quaternion's y/, agent.setQuaternion, 0, NaN, 0, 1);
            assertThrows(ArgumentError, /matrix must only turn/, function():void
                {
                    var shear:Matrix3D = new Matrix3D();
                    var data:Vector.<Number> = shear.rawData;
                    data[4] = 0.01;
                    shear.rawData = data;
                    agent.setMatrix(shear);
                });
            assertEquals("as it was", revision, agent.revision);
        }

        private static function randomQuaternion(random:SeededRandom):Vector.<Number>
        {
            var q:Vector.<Number> = new Vector.<Number>(4);
            var squared:Number = 0;
            while (squared < 0.01 || squared > 1)
            {
                squared = 0;
                for (var k:int = 0; k < 4; k++)
                {
                    q[k] = random.between(-1, 1);
                    squared += q[k] * q[k];
                }
            }
            var length:Number = q[3] < 0 ? -Math.sqrt(squared) : Math.sqrt(squared);
            for (k = 0; k < 4; k++)
            {
                q[k] /= length;
            }
            return q;
        }

        private static function assertRotation(rows:String, x:Number, y:Number, z:Number, w:Number):void
        {
            var agent:Agent = new Agent("bear");
            agent.setQuaternion(x, y, z, w);
            var data:Vector.<Number> = agent.getMatrix().rawData;
            var found:Array = [data[0], data[4], data[8], data[1], data[5], data[9], data[2], data[6], data[10]];
            var expected:Array = rows.split(" ");
            for (var i:int = 0; i < 9; i++)
            {
                assertNear(rows + ": entry " + i, Number(expected[i]), found[i], 1e-6);
            }
        }

        private static function assertNear(message:String, expected:Number, found:Number, tolerance:Number):void
        {
            assertTrue(message + ": " + found + ", not " + expected, Math.abs(found - expected) <= tolerance);
        }

        private static function difference(a:Agent, b:Agent):Number
        {
            return differenceOf(a.freshPlacement(), b.freshPlacement());
        }

        // The largest of the entries'.
        private static function differenceOf(a:Placement, b:Placement):Number
        {
            var ofA:Vector.<Number> = new Vector.<Number>(9);
            var ofB:Vector.<Number> = new Vector.<Number>(9);
            a.readRows(ofA, 0);
            b.readRows(ofB, 0);
            var largest:Number = 0;
            for (var i:int = 0; i < 9; i++)
            {
                largest = Math.max(largest, Math.abs(ofA[i] - ofB[i]));
            }
            return largest;
        }
    }
}

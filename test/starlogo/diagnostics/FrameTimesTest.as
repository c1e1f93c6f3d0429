package starlogo.diagnostics
{
    import evaluation.EveryPairSystem;
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import support.assertThrows;
    import support.create;

    public class FrameTimesTest
    {
        [Test]
        public function aTimeIsNotNegative():void
        {
            var times:FrameTimes = new FrameTimes();
            assertThrows(RangeError, /milliseconds must be 0 or more, not -1/, times.add, -1);
            assertEquals(0, times.frames);
        }

        [Test]
        public function meanMedianAndMost():void
        {
            var times:FrameTimes = new FrameTimes();
            assertEquals("mean 0.00 ms, median 0.00 ms, most 0.00 ms", times.toString());
            for each (var time:Number in [3, 0, 0, 5])
            {
                times.add(time);
            }
            assertEquals("mean 2.00 ms, median 1.50 ms, most 5.00 ms", times.toString());
            times.add(100);
            assertEquals(3, times.median);
            assertEquals(100, times.most);
            assertEquals(21.6, times.mean);
            assertEquals(5, times.frames);
            times.clear();
            assertEquals(0, times.frames);
            assertEquals(0, times.most);
            assertThrows(RangeError, /capacity must be at least 1: 0/, create, FrameTimes, 0);
        }

        [Test]
        public function theOldestFramesMakeRoom():void
        {
            var random:SeededRandom = new SeededRandom(9);
            var times:FrameTimes = new FrameTimes(7);
            var all:Array = [];
            for (var i:int = 0; i < 100; i++)
            {
                all.push(random.integer(0, 40));
                times.add(all[i]);
                var last:Array = all.slice(-7).sort(Array.NUMERIC);
                var sum:Number = 0;
                for each (var time:Number in last)
                {
                    sum += time;
                }
                assertEquals(last.length, times.frames);
                assertEquals(last[last.length - 1], times.most);
                assertEquals((last[last.length >> 1] + last[(last.length - 1) >> 1]) / 2, times.median);
                assertTrue(Math.abs(times.mean - sum / last.length) < 1e-12);
            }
        }

        [Test]
        public function everyFrameOfAnySystemIsMeasured():void
        {
            for each (var system:CollisionSystem in [new BinCollider(), new EveryPairSystem()])
            {
                var recorder:CollisionRecorder = new CollisionRecorder(system);
                var collision:Collision = new Collision(recorder);
                var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("sphere")];
                var spent:int = 0;
                collision.onCollision("turtles", "turtles", function(collider:Agent, collidee:Agent):void
                    {
                        spent++;
                    });
                for (var i:int = 0; i < 5; i++)
                {
                    collision.update(agents);
                }
                assertEquals(10, spent);
                assertEquals(5, recorder.frames);
                assertEquals(5, recorder.findTimes.frames);
                assertEquals(5, recorder.frameTimes.frames);
                assertTrue(recorder.frameTimes.mean >= recorder.findTimes.mean);
                assertTrue(recorder.timesToText(), /^5 frames, 1\.0 collisions a frame\nfind: mean .* ms\nframe: mean .* ms$/.test(recorder.timesToText()));
                recorder.findCollisions(agents);
                assertEquals(6, recorder.findTimes.frames);
                assertEquals("without a Collision there is no whole frame", 5, recorder.frameTimes.frames);
                recorder.clear();
                assertEquals(0, recorder.findTimes.frames + recorder.frameTimes.frames);
            }
        }
    }
}

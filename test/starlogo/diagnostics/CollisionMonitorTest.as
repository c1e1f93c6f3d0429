package starlogo.diagnostics
{
    import evaluation.EveryPairSystem;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import flash.events.Event;
    import flash.events.KeyboardEvent;
    import flash.text.TextField;
    import flash.ui.Keyboard;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.assumeThat;
    import org.hamcrest.object.equalTo;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.engine;
    import support.TestStage;
    import support.assertThrows;
    import support.assign;
    import support.create;
    import support.ignore;

    use namespace engine;

    public class CollisionMonitorTest
    {
        private static const REFRESH_FRAMES:int = 12;

        private var _collision:Collision = new Collision(new EveryPairSystem());
        private var _monitor:CollisionMonitor = new CollisionMonitor(_collision);

        [Before]
        public function make():void
        {
            _collision.onCollision("turtles", "turtles", ignore);
        }

        [After]
        public function takeAway():void
        {
            if (_monitor.stage != null)
            {
                _monitor.stage.removeChild(_monitor);
            }
        }

        [Test]
        public function showsWhatTheLastFrameDid():void
        {
            var scene:Scene = Scenes.crowd(7, "spheres");
            _collision.update(scene.agents);
            play(REFRESH_FRAMES);
            assertEquals("agents", "7", valueOf("agents"));
            assertEquals("collisions", "21", valueOf("collisions"));
            assertEquals("either agent's handler", "42", valueOf("handler calls"));
            assertTrue(valueOf("memory"), /^\d+\.\d MB$/.test(valueOf("memory")));
            assertTrue("and what it costs itself: " + valueOf("this monitor"), /^\d+\.\d\d ms, \d+\.\d %$/.test(valueOf("this monitor")));
        }

        [Test]
        public function showsTestsOfHulls():void
        {
            _collision.statistics.hullTests = 12;
            play(REFRESH_FRAMES);
            assertEquals("12", valueOf("hulls"));
            assertEquals("0", valueOf("box-box"));
        }

        [Test]
        public function theTimesDoNotLieOnOneAnother():void
        {
            _collision.statistics.frameMs = 44.4;
            play(REFRESH_FRAMES);
            var mean:TextField = fieldWith("44.4 ms");
            var others:TextField = fieldWith("median");
            // Adobe's VM measures no text
            assumeThat(mean.textWidth > 0, equalTo(true));
            assertTrue(mean.textWidth + " " + others.textWidth, mean.textWidth + others.textWidth < mean.width - 8);
            assertTrue("above the graph", others.y + others.textHeight < 58);
        }

        [Test]
        public function refreshesItsNumbersAfterSomeFrames():void
        {
            _collision.update(Scenes.crowd(3, "spheres").agents);
            play(REFRESH_FRAMES);
            _collision.update(Scenes.crowd(5, "spheres").agents);
            play(REFRESH_FRAMES - 1);
            assertEquals("3", valueOf("agents"));
            play(1);
            assertEquals("5", valueOf("agents"));
        }

        [Test]
        public function maySwitchToAnotherGame():void
        {
            var other:Collision = new Collision(new EveryPairSystem());
            other.update(Scenes.crowd(9, "spheres").agents);
            _monitor.collision = other;
            play(REFRESH_FRAMES);
            assertEquals("9", valueOf("agents"));
        }

        [Test]
        public function hiddenItDoesNothing():void
        {
            _monitor.isShown = true;
            _monitor.isShown = false;
            assertFalse(_monitor.visible);
            assertFalse(_monitor.hasEventListener(Event.ENTER_FRAME));
        }

        [Test]
        public function theKeyHidesAndShowsIt():void
        {
            TestStage.stage.addChild(_monitor);
            press(Keyboard.BACKQUOTE);
            assertFalse("hidden", _monitor.isShown || _monitor.visible);
            press(Keyboard.SPACE);
            assertFalse("another key", _monitor.isShown);
            press(Keyboard.BACKQUOTE);
            assertTrue("shown", _monitor.isShown && _monitor.visible);
            _monitor.toggleKey = Keyboard.F2;
            press(Keyboard.BACKQUOTE);
            assertTrue("the key is another now", _monitor.isShown);
            press(Keyboard.F2);
            assertFalse(_monitor.isShown);
        }

        [Test]
        public function takenOffTheStageItHearsNoKey():void
        {
            TestStage.stage.addChild(_monitor);
            TestStage.stage.removeChild(_monitor);
            press(Keyboard.BACKQUOTE);
            assertTrue(_monitor.isShown);
            assertFalse(_monitor.hasEventListener(Event.ENTER_FRAME));
        }

        [Test]
        public function hiddenItTakesInNoFrame():void
        {
            TestStage.stage.addChild(_monitor);
            _collision.update(Scenes.crowd(3, "spheres").agents);
            playOnStage(REFRESH_FRAMES - 1);
            press(Keyboard.BACKQUOTE);
            assertFalse(_monitor.hasEventListener(Event.ENTER_FRAME));
            playOnStage(REFRESH_FRAMES);
            assertEquals("no number", "", valueOf("agents"));
            press(Keyboard.BACKQUOTE);
            playOnStage(REFRESH_FRAMES - 1);
            assertEquals("it starts anew", "", valueOf("agents"));
            playOnStage(1);
            assertEquals("3", valueOf("agents"));
        }

        [Test]
        public function needsACollision():void
        {
            assertThrows(ArgumentError, /collision/, create, CollisionMonitor, null);
            assertThrows(ArgumentError, /collision/, assign, _monitor, "collision", null);
        }

        private static function press(keyCode:uint):void
        {
            TestStage.stage.dispatchEvent(new KeyboardEvent(KeyboardEvent.KEY_DOWN, true, false, 0, keyCode));
        }

        // Frames as the player sends them to what is on the stage; no frame of its own passes during a test.
        private function playOnStage(frames:int):void
        {
            for (var i:int = 0; i < frames; i++)
            {
                _monitor.dispatchEvent(new Event(Event.ENTER_FRAME));
            }
        }

        // Frames without a stage.
        private function play(frames:int):void
        {
            for (var i:int = 0; i < frames; i++)
            {
                _monitor.onFrame();
            }
        }

        // The number beside a label.
        private function valueOf(label:String):String
        {
            var labels:Array = null;
            for (var i:int = 0; i < _monitor.numChildren; i++)
            {
                var field:TextField = _monitor.getChildAt(i) as TextField;
                if (field == null)
                {
                    continue;
                }
                var lines:Array = field.text.split(/[\r\n]/);
                if (lines.length > 2 && lines.indexOf(label) >= 0)
                {
                    labels = lines;
                }
                else if (labels != null)
                {
                    return lines[labels.indexOf(label)];
                }
            }
            return "no such label";
        }

        // The text that has a word.
        private function fieldWith(word:String):TextField
        {
            for (var i:int = 0; i < _monitor.numChildren; i++)
            {
                var field:TextField = _monitor.getChildAt(i) as TextField;
                if (field != null && field.text.indexOf(word) >= 0)
                {
                    return field;
                }
            }
            return null;
        }
    }
}

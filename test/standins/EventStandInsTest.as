package standins
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.EventDispatcher;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.events.SecurityErrorEvent;
    import flash.events.TextEvent;
    import flash.events.TimerEvent;
    import flash.utils.Timer;
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import standin.Machine;
    import standin.flash.errors.IllegalOperationError;
    import standin.flash.events.ErrorEvent;
    import standin.flash.events.Event;
    import standin.flash.events.EventDispatcher;
    import standin.flash.events.IOErrorEvent;
    import standin.flash.events.ProgressEvent;
    import standin.flash.events.SecurityErrorEvent;
    import standin.flash.events.TextEvent;
    import standin.flash.events.TimerEvent;
    import standin.flash.utils.Timer;
    import standin.flash.utils.getTimer;
    import support.Transcript;

    /** The stand-ins for events, errors and timers, under another package's name, against the player's own. */
    public class EventStandInsTest
    {
        private static const PLAYER:Object = {Event: flash.events.Event, TextEvent: flash.events.TextEvent, ErrorEvent: flash.events.ErrorEvent,
                IOErrorEvent: flash.events.IOErrorEvent, SecurityErrorEvent: flash.events.SecurityErrorEvent,
                ProgressEvent: flash.events.ProgressEvent, TimerEvent: flash.events.TimerEvent, EventDispatcher: flash.events.EventDispatcher,
                Timer: flash.utils.Timer, IllegalOperationError: flash.errors.IllegalOperationError};
        private static const STAND_IN:Object = {Event: standin.flash.events.Event, TextEvent: standin.flash.events.TextEvent,
                ErrorEvent: standin.flash.events.ErrorEvent, IOErrorEvent: standin.flash.events.IOErrorEvent,
                SecurityErrorEvent: standin.flash.events.SecurityErrorEvent, ProgressEvent: standin.flash.events.ProgressEvent,
                TimerEvent: standin.flash.events.TimerEvent, EventDispatcher: standin.flash.events.EventDispatcher,
                Timer: standin.flash.utils.Timer, IllegalOperationError: standin.flash.errors.IllegalOperationError};

        private var _machine:Object;
        private var _uncaught:Array;
        private var _pending:Array;
        private var _now:Number;

        [Before]
        public function standInForTheMachine():void
        {
            _machine = {};
            for each (var name:String in ["now", "timer", "setTimeout", "clearTimeout", "reportError", "className"])
            {
                _machine[name] = Machine[name];
            }
            _uncaught = [];
            _pending = [];
            _now = 1000.75;
            Machine.now = function():Number
            {
                return _now;
            };
            Machine.timer = null;
            Machine.setTimeout = function(callback:Function, ms:Number):uint
            {
                _pending.push({callback: callback, at: _now + ms});
                return _pending.length;
            };
            Machine.clearTimeout = function(id:uint):void
            {
                _pending[id - 1].callback = null;
            };
            Machine.reportError = function(error:*):void
            {
                _uncaught.push(String(error));
            };
            Machine.className = Machine.className || getQualifiedClassName; // on Adobe's VM this asks the machine
        }

        [After]
        public function takeItAway():void
        {
            for (var name:String in _machine)
            {
                Machine[name] = _machine[name];
            }
            Machine.frameListeners.length = 0;
        }

        /** Lets time pass: whatever falls due is called, in order. */
        private function pass(ms:Number):void
        {
            var end:Number = _now + ms;
            while (true)
            {
                var next:Object = null;
                for each (var pending:Object in _pending)
                {
                    if (pending.callback != null && pending.at <= end && (next == null || pending.at < next.at))
                    {
                        next = pending;
                    }
                }
                if (next == null)
                {
                    break;
                }
                var callback:Function = next.callback;
                next.callback = null;
                _now = next.at;
                callback();
            }
            _now = end;
        }

        [Test]
        public function orders():void
        {
            compare(orderCalls);
        }

        [Test]
        public function events():void
        {
            compare(eventCalls);
        }

        [Test]
        public function errors():void
        {
            compare(errorCalls);
        }

        [Test]
        public function timersSettings():void
        {
            compare(timerCalls);
        }

        [Test]
        public function whatAListenerThrowsStopsNobody():void
        {
            var heard:Array = [];
            var dispatcher:standin.flash.events.EventDispatcher = new standin.flash.events.EventDispatcher();
            dispatcher.addEventListener("fall", function(event:standin.flash.events.Event):void
                {
                    throw new Error("over a stone");
                });
            dispatcher.addEventListener("fall", function(event:standin.flash.events.Event):void
                {
                    heard.push(event.type);
                });
            assertTrue(dispatcher.dispatchEvent(new standin.flash.events.Event("fall")));
            assertEquals("fall", heard.join());
            assertEquals("Error: over a stone", _uncaught.join());
        }

        [Test]
        public function errorsThatNobodyListensForAreTold():void
        {
            var dispatcher:standin.flash.events.EventDispatcher = new standin.flash.events.EventDispatcher();
            dispatcher.dispatchEvent(new standin.flash.events.Event("ioError"));
            assertEquals("no error", 0, _uncaught.length);
            dispatcher.dispatchEvent(new standin.flash.events.IOErrorEvent("ioError", false, false, "lost"));
            assertEquals(1, _uncaught.length);
            assertTrue(_uncaught[0], /2044.*ioError.*lost/.test(_uncaught[0]));
        }

        [Test]
        public function whoListensForFramesIsKnown():void
        {
            var dispatcher:standin.flash.events.EventDispatcher = new standin.flash.events.EventDispatcher();
            dispatcher.addEventListener("enterFrame", isNoError);
            dispatcher.addEventListener("enterFrame", standInForNothing);
            dispatcher.addEventListener("exitFrame", isNoError);
            assertEquals(1, Machine.frameListeners.length);
            dispatcher.removeEventListener("enterFrame", isNoError);
            assertEquals(dispatcher, Machine.frameListeners[0]);
            dispatcher.removeEventListener("enterFrame", isNoError);
            dispatcher.removeEventListener("enterFrame", standInForNothing);
            assertEquals(0, Machine.frameListeners.length);
        }

        private static function isNoError(event:*):void
        {
        }

        private static function standInForNothing(event:*):void
        {
        }

        [Test]
        public function timersRingUntilTheyAreDone():void
        {
            var rings:Array = [];
            var timer:standin.flash.utils.Timer = new standin.flash.utils.Timer(100, 3);
            timer.addEventListener("timer", function(event:standin.flash.events.TimerEvent):void
                {
                    rings.push(timer.running ? "rings" : "rests");
                });
            timer.addEventListener("timerComplete", function(event:standin.flash.events.TimerEvent):void
                {
                    rings.push(timer.running ? "runs" : "done");
                });
            timer.start();
            timer.start();
            pass(99);
            assertEquals("", rings.join());
            pass(150);
            assertEquals("rings,rings", rings.join());
            timer.stop();
            pass(500);
            timer.start();
            pass(100);
            assertEquals("rings,rings,rings,done", rings.join());
            pass(500);
            assertEquals(4, rings.length);
            timer.reset();
            timer.start();
            pass(300);
            assertEquals("it counts anew", 8, rings.length);
        }

        [Test]
        public function theClockIsTheMachines():void
        {
            assertEquals(1000, standin.flash.utils.getTimer());
            Machine.timer = function():int
            {
                return 7;
            };
            assertEquals(7, standin.flash.utils.getTimer());
        }

        private function compare(calls:Function):void
        {
            var players:Transcript = new Transcript();
            var ours:Transcript = new Transcript();
            calls(PLAYER, players);
            calls(STAND_IN, ours);
            assertTrue(ours.length > 0);
            players.assertAlike(ours);
        }

        private function orderCalls(of:Object, to:Transcript):void
        {
            var random:SeededRandom = new SeededRandom(12);
            for (var round:int = 0; round < 60; round++)
            {
                var dispatcher:* = new of["EventDispatcher"]();
                var listeners:Array = [];
                var heard:Array = [];
                for (var i:int = 0; i < 8; i++)
                {
                    listeners.push(listenerOf(i, heard, dispatcher, listeners));
                }
                for (i = 0; i < 14; i++)
                {
                    var listener:Function = random.pick(listeners);
                    var type:String = random.pick(["a", "a", "b", "toString", "hasOwnProperty"]);
                    if (random.integer(0, 4) == 0)
                    {
                        dispatcher.removeEventListener(type, listener);
                    }
                    else
                    {
                        dispatcher.addEventListener(type, listener, false, random.pick([0, 0, 1, -1]));
                    }
                }
                for each (type in ["a", "b", "toString", "hasOwnProperty", "none"])
                {
                    to.note("has " + type, [dispatcher.hasEventListener(type), dispatcher.willTrigger(type)]);
                    var event:* = new of["Event"](type, random.chance(), random.chance());
                    to.note("dispatch " + type, [dispatcher.dispatchEvent(event), heard, event.isDefaultPrevented()]);
                    to.note("again", [dispatcher.dispatchEvent(event), heard, event.target == dispatcher]);
                }
            }
            to.attempt("null", function():*
                {
                    return dispatcher.addEventListener("a", null);
                });
            to.attempt("remove null", function():*
                {
                    return dispatcher.removeEventListener("a", null);
                });
            to.attempt("no event", function():*
                {
                    return dispatcher.dispatchEvent(null);
                });
        }

        private static function listenerOf(number:int, heard:Array, dispatcher:*, all:Array):Function
        {
            return function(event:*):void
            {
                heard.push(number, event.target == dispatcher, event.currentTarget == dispatcher, event.eventPhase);
                if (number == 5)
                {
                    event.preventDefault();
                }
                if (number == 6)
                {
                    event.stopImmediatePropagation();
                }
                if (number == 7)
                {
                    event.stopPropagation();
                    dispatcher.removeEventListener("a", all[1]);
                    dispatcher.addEventListener("a", all[2]);
                }
            };
        }

        private function eventCalls(of:Object, to:Transcript):void
        {
            for each (var event:* in [new of["Event"]("a"), new of["Event"]("a", true, true), new of["TextEvent"]("t", true, false, "text"),
                        new of["ErrorEvent"]("e", false, true, "wrong", 7), new of["IOErrorEvent"]("i", false, false, "lost", 8),
                        new of["SecurityErrorEvent"]("s", false, false, "no", 9), new of["ProgressEvent"]("p", false, false, 3, 10), new of["TimerEvent"]("t")])
            {
                for each (var each:* in [event, event.clone()])
                {
                    to.note("an event", [each.toString(), each.type, each.bubbles, each.cancelable, each.target, each.currentTarget,
                                each.eventPhase, each.isDefaultPrevented()]);
                    to.note("its class", getQualifiedClassName(each).split("::").pop());
                    to.note("its own", ["text" in each ? each.text : "", "errorID" in each ? each.errorID : 0]);
                }
            }
            var dispatcher:* = new of["EventDispatcher"]();
            var owner:* = new of["EventDispatcher"](dispatcher);
            owner.addEventListener("a", function(event:*):void
                {
                    to.note("target of another", [event.target == dispatcher, event.currentTarget == dispatcher]);
                });
            owner.dispatchEvent(new of["Event"]("a"));
            to.note("text", String(dispatcher));
            for each (var constant:String in ["COMPLETE", "ENTER_FRAME", "ADDED_TO_STAGE", "CANCEL", "RESIZE"])
            {
                to.note(constant, of.Event[constant]);
            }
            to.note("constants", [of.IOErrorEvent.IO_ERROR, of.SecurityErrorEvent.SECURITY_ERROR, of.ErrorEvent.ERROR, of.ProgressEvent.PROGRESS,
                        of.TimerEvent.TIMER, of.TimerEvent.TIMER_COMPLETE, of.TextEvent.LINK]);
        }

        // Ruffle leaves its name at Error
        private function errorCalls(of:Object, to:Transcript):void
        {
            var error:Error = new of["IllegalOperationError"]("what", 5);
            to.note("an error", [error.message, error.errorID, new of["IllegalOperationError"]().message]);
        }

        private function timerCalls(of:Object, to:Transcript):void
        {
            for each (var delay:Number in [-1, NaN, Infinity])
            {
                to.attempt("a delay of " + delay, function():*
                    {
                        return new of["Timer"](delay);
                    });
            }
            var timer:* = new of["Timer"](5000, 3);
            to.note("made", [timer.delay, timer.running]);
            timer.start();
            to.note("started", timer.running);
            timer.stop();
            to.note("stopped", timer.running);
            timer.start();
            timer.reset();
            to.note("reset", timer.running);
            assertFalse(timer.running);
        }
    }
}

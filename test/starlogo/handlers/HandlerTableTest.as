package starlogo.handlers
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.search.BreedInterests;

    use namespace engine;

    /** What frames call while a game adds and removes handlers, against a plain list of the handlers that are there. */
    public class HandlerTableTest
    {
        private static const BREEDS:Array = ["bears", "trees", Breeds.ANY_BREED];
        private static const NAMES:Object = {1: "start", 2: "collision", 4: "end"};

        private var _table:HandlerTable = new HandlerTable();
        private var _random:SeededRandom = new SeededRandom(1);

        // The handlers that are there, in the order in which they were added: { phase, breed, other, callback }. The second list has those of the frame.
        private var _present:Array = [];
        private var _ofFrame:Array = [];
        private var _isChanged:Boolean = false;
        private var _functions:Array = [function(a:Agent, b:Agent):void
            {
            }, function(a:Agent, b:Agent, contact:Object):void
            {
            }
        ];

        [Test]
        public function eachFrameTakesTheHandlersThatAreThere():void
        {
            var frames:Object = {"false": 0, "true": 0};
            for (var frame:int = 0; frame < 400; frame++)
            {
                for (var changes:int = _random.integer(0, 4); changes > 0; changes--)
                {
                    change();
                    assertCalls();
                }
                frames[_isChanged]++;
                beginFrame();
                assertCalls();
            }
            assertTrue(frames["true"] + " frames had changes, " + frames["false"] + " had none", frames["true"] > 200 && frames["false"] > 50);
        }

        /** With its last handler a kind of pair leaves the search: a game that removed it searches for nothing. */
        [Test]
        public function aRemovedHandlerCountsAsAChange():void
        {
            add("bears", "trees", CollisionHandler.START, _functions[1]);
            beginFrame();
            assertEquals(CollisionHandler.START, _table.contactPhases);
            remove("bears", "trees", CollisionHandler.START, _functions[1]);
            beginFrame();
            assertEquals(0, _present.length);
        }

        private function change():void
        {
            var breed:String = _random.pick(BREEDS);
            var other:String = _random.pick(BREEDS);
            var phase:int = _random.pick([CollisionHandler.START, CollisionHandler.EVERY_FRAME, CollisionHandler.END]);
            var callback:Function = _random.pick(_functions);
            if (_random.chance(0.02))
            {
                _table.clear();
                _present = [];
                _isChanged = true;
            }
            else if (_random.chance(0.4))
            {
                add(breed, other, phase, callback);
            }
            else
            {
                remove(breed, other, phase, callback);
            }
        }

        private function add(breed:String, other:String, phase:int, callback:Function):void
        {
            _table.add(breed, other, callback, phase);
            _present.push({phase: phase, breed: breed, other: other, callback: callback});
            _isChanged = true;
        }

        private function remove(breed:String, other:String, phase:int, callback:Function):void
        {
            var wanted:Array = _present.filter(function(one:Object, index:int, all:Array):Boolean
                {
                    return one.phase == phase && one.breed == breed && one.other == other && one.callback == callback;
                });
            assertEquals(wanted.length > 0, _table.remove(breed, other, callback, phase));
            if (wanted.length > 0)
            {
                _present.splice(_present.indexOf(wanted[0]), 1);
                _isChanged = true;
            }
        }

        private function beginFrame():void
        {
            var before:BreedInterests = _table.interests;
            _table.begin(new <Agent>[new Agent("cube", "bears"), new Agent("cube", "trees")]);
            assertEquals("the search begins anew after a change alone", _isChanged, _table.interests !== before);
            _isChanged = false;
            _ofFrame = _present.concat();
            var phases:int = 0;
            var contactPhases:int = 0;
            var named:Object = {};
            for each (var one:Object in _present)
            {
                phases |= one.phase;
                contactPhases |= one.callback == _functions[1] && one.phase != CollisionHandler.END ? one.phase : 0;
                named[one.breed] = named[one.other] = true;
            }
            assertEquals(phases, _table.phases);
            assertEquals(contactPhases, _table.contactPhases);
            for each (var breed:String in BREEDS)
            {
                // Ruffle returns null for a Boolean that a Vector has at first
                assertEquals(breed, breed in named, Boolean(_table.interests.isNamed(Breeds.NAMES.numberOf(breed))));
            }
        }

        // What a bear and a tree that touch call: handlers that the frame began with and that are still there.
        private function assertCalls():void
        {
            var pair:PairHandlers = _table.handlersOf(Breeds.NAMES.numberOf("bears"), Breeds.NAMES.numberOf("trees"));
            var found:Array = [];
            for (var i:int = 0; i < pair.handlers.length; i++)
            {
                if (!pair.handlers[i].isRemoved)
                {
                    found.push(textOf(i < pair.splitIndex, pair.handlers[i].phase, pair.handlers[i].callback));
                }
            }
            assertEquals(callsOf("bears", "trees", true).concat(callsOf("trees", "bears", false)).join("\n"), found.join("\n"));
        }

        private function callsOf(breed:String, other:String, isFirst:Boolean):Array
        {
            var calls:Array = [];
            for (var phase:int = CollisionHandler.START; phase <= CollisionHandler.END; phase *= 2)
            {
                for each (var one:Object in _ofFrame)
                {
                    var fits:Boolean = (one.breed == breed || one.breed == Breeds.ANY_BREED) && (one.other == other || one.other == Breeds.ANY_BREED);
                    if (fits && one.phase == phase && _present.indexOf(one) >= 0)
                    {
                        calls.push(textOf(isFirst, phase, one.callback));
                    }
                }
            }
            return calls;
        }

        private function textOf(isFirst:Boolean, phase:int, callback:Function):String
        {
            return (isFirst ? "first " : "second ") + NAMES[phase] + " " + _functions.indexOf(callback);
        }
    }
}

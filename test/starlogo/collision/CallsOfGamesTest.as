package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.EachCollider;
    import support.Effort;
    import support.landOf;

    /**
     * All calls of random games: starts, collisions and ends, with their contacts and in their order. They are compared with those of a loop over
     * all pairs in the order of the list, which keeps the touches in a list too.
     */
    public class CallsOfGamesTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "cylinder"];
        private static const BREEDS:Array = ["bears", "balls", "walls"];
        private static const KINDS:Array = ["start", "collision", "end"];
        private static const FRAMES:int = 20;

        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder());
        private var _random:SeededRandom;
        private var _agents:Vector.<Agent>;

        // Each is kind, breed, otherBreed, takesContact.
        private var _handlers:Array;

        // Each is first, second, the breed of the first, the breed of the second, in the order in which they began.
        private var _touches:Array;
        private var _calls:Array;
        private var _counts:Object = {};

        [Test]
        public function areThoseOfALoop():void
        {
            for (var game:int = 0; game < Effort.choose(30, 300); game++)
            {
                _random = new SeededRandom(1000 + game);
                play(game, EachCollider.ALL_NAMES[game % EachCollider.ALL_NAMES.length]);
            }
            for each (var kind:String in KINDS)
            {
                assertTrue(_counts[kind] + " calls of " + kind, _counts[kind] > 500);
            }
            assertTrue(_counts.contacts + " contacts", _counts.contacts > 500);
        }

        private function play(game:int, name:String):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < 24; i++)
            {
                _agents.push(makeAgent());
            }
            var collision:Collision = new Collision(EachCollider.make(name, _greatLand));
            _handlers = [];
            _touches = [];
            for (i = _random.integer(1, 6); i > 0; i--)
            {
                addHandler(collision, _random.pick(KINDS), _random.pick(BREEDS.concat("*")), _random.pick(BREEDS.concat("*")), _random.chance());
            }
            var most:Number = _random.pick([0.02, 0.05, 1]);
            for (var frame:int = 0; frame < FRAMES; frame++)
            {
                _calls = [];
                collision.update(_agents);
                var made:String = _calls.join("\n");
                _calls = [];
                loop(EachCollider.make(name, _greatLand));
                assertEquals("game " + game + " of " + name + ", frame " + frame, _calls.join("\n"), made);
                change(most);
            }
        }

        private function addHandler(collision:Collision, kind:String, breed:String, otherBreed:String, takesContact:Boolean):void
        {
            var index:int = _handlers.push([kind, breed, otherBreed, takesContact && kind != "end"]) - 1;
            var handler:Function = function(a:Agent, b:Agent):void
            {
                note(index, a, b, null);
            };
            if (_handlers[index][3])
            {
                handler = function(a:Agent, b:Agent, contact:Contact):void
                {
                    note(index, a, b, contact);
                };
            }
            switch (kind)
            {
                case "start":
                    collision.onCollisionStart(breed, otherBreed, handler);
                    break;
                case "collision":
                    collision.onCollision(breed, otherBreed, handler);
                    break;
                case "end":
                    collision.onCollisionEnd(breed, otherBreed, handler);
                    break;
            }
        }

        private function note(index:int, a:Agent, b:Agent, contact:Contact):void
        {
            var numbers:String = contact == null ? "" : [contact.time, contact.depth, contact.approachSpeed, contact.point, contact.normal.x + 0, contact.normal.y + 0, contact.normal.z + 0].join(" ");
            _calls.push([_handlers[index][0], index, a.id, b.id, numbers].join(" "));
            _counts[_handlers[index][0]] = int(_counts[_handlers[index][0]]) + 1;
            _counts.contacts = int(_counts.contacts) + (contact == null ? 0 : 1);
        }

        // The calls of a frame: first of the touches that have ended, then of the pairs.
        private function loop(twin:Collider):void
        {
            twin.findCollisions(_agents);
            var pairs:Array = [];
            for (var i:int = 0; i < _agents.length; i++)
            {
                for (var j:int = i + 1; j < _agents.length; j++)
                {
                    if (twin.areColliding(_agents[i], _agents[j]))
                    {
                        pairs.push([_agents[i], _agents[j]]);
                    }
                }
            }
            endTouches(pairs);
            for each (var pair:Array in pairs)
            {
                var isTracked:Boolean = tracks(pair[0].breed, pair[1].breed);
                var isStarting:Boolean = isTracked && indexOfTouch(pair) < 0;
                if (isStarting)
                {
                    _touches.push([pair[0], pair[1], pair[0].breed, pair[1].breed]);
                }
                call(twin, isStarting ? ["start", "collision"] : ["collision"], pair[0], pair[1], pair[0].breed, pair[1].breed);
                call(twin, isStarting ? ["start", "collision"] : ["collision"], pair[1], pair[0], pair[1].breed, pair[0].breed);
            }
        }

        private function endTouches(pairs:Array):void
        {
            var kept:Array = [];
            for each (var touch:Array in _touches)
            {
                var goesOn:Boolean = false;
                for each (var pair:Array in pairs)
                {
                    goesOn ||= isOf(touch, pair) && touch[2] == touch[0].breed && touch[3] == touch[1].breed;
                }
                if (goesOn)
                {
                    kept.push(touch);
                    continue;
                }
                call(null, ["end"], touch[0], touch[1], touch[2], touch[3]);
                call(null, ["end"], touch[1], touch[0], touch[3], touch[2]);
            }
            _touches = kept;
        }

        private function call(twin:Collider, kinds:Array, collider:Agent, collidee:Agent, breed:String, otherBreed:String):void
        {
            for each (var kind:String in kinds)
            {
                for (var i:int = 0; i < _handlers.length; i++)
                {
                    if (_handlers[i][0] == kind && matches(_handlers[i], breed, otherBreed))
                    {
                        note(i, collider, collidee, _handlers[i][3] ? twin.contactOf(collider, collidee) : null);
                    }
                }
            }
        }

        // Whether two breeds have handlers for starts or ends, either way.
        private function tracks(breed:String, otherBreed:String):Boolean
        {
            for each (var handler:Array in _handlers)
            {
                if (handler[0] != "collision" && (matches(handler, breed, otherBreed) || matches(handler, otherBreed, breed)))
                {
                    return true;
                }
            }
            return false;
        }

        private static function matches(handler:Array, breed:String, otherBreed:String):Boolean
        {
            return (handler[1] == "*" || handler[1] == breed) && (handler[2] == "*" || handler[2] == otherBreed);
        }

        private function indexOfTouch(pair:Array):int
        {
            for (var i:int = 0; i < _touches.length; i++)
            {
                if (isOf(_touches[i], pair))
                {
                    return i;
                }
            }
            return -1;
        }

        private static function isOf(touch:Array, pair:Array):Boolean
        {
            return touch[0] === pair[0] && touch[1] === pair[1] || touch[0] === pair[1] && touch[1] === pair[0];
        }

        private function makeAgent():Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES), _random.pick(BREEDS));
            agent.moveTo(_random.between(-3, 3), _random.between(-3, 3), _random.between(0, 0.5));
            agent.heading = _random.between(0, 360);
            agent.size = _random.pick([0.5, 1, 1, 2]);
            agent.hierarchical = _random.chance(0.3);
            return agent;
        }

        private function change(most:Number):void
        {
            for each (var agent:Agent in _agents)
            {
                if (_random.chance(most))
                {
                    agent.moveTo(agent.x * 0.95 + _random.normal() * 0.4, agent.y * 0.95 + _random.normal() * 0.4, agent.z);
                }
            }
            var some:int = _random.integer(0, _agents.length - 1);
            switch (_random.integer(0, 11))
            {
                case 0:
                    _agents.splice(some, 1);
                    break;
                case 1:
                    _agents.splice(some, 0, makeAgent());
                    break;
                case 2:
                    _agents.push(_agents.splice(some, 1)[0]);
                    break;
                case 3:
                    _agents.reverse();
                    break;
                case 4:
                    _agents[some].breed = _random.pick(BREEDS);
                    break;
                case 5:
                    _agents[some].size = _random.between(0.3, 2);
                    break;
            }
        }
    }
}

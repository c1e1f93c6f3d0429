package soak
{
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;

    /**
     * The game of a soak. Whatever a game may do happens all the time, in the game's own turn and in handlers, while models, agents, handlers and
     * collision systems come and go. An error that was not meant ends it.
     *
     * <p>This file is long because each thing that may happen in a game is a short function of it.</p>
     */
    public final class SoakGame
    {
        private static const BREEDS:Array = ["bears", "balls", "walls", "turtles"];
        private static const FEWEST:int = 30;
        private static const MOST:int = 60;
        private static const MOST_HANDLERS:int = 10;
        private static const MEANT:String = "meant";

        private var _checkEvery:int;
        private var _random:SeededRandom;
        private var _counts:SoakCounts = new SoakCounts(countedThings());
        private var _models:SoakModels;
        private var _witness:SoakWitness;
        private var _systems:SoakSystems;
        private var _check:SoakCheck;
        private var _collision:Collision;
        private var _other:Collision;
        private var _touches:Vector.<SoakTouches>;
        private var _ground:SoakGround;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _handlers:Vector.<SoakHandler> = new Vector.<SoakHandler>();
        private var _frame:int = 0;
        private var _thrown:int = 0;

        // in the frame before a check no system and no model changes any more, in that of a check nothing does
        private var _isCalm:Boolean = false;
        private var _isChecking:Boolean = false;

        /**
         * @param seed decides all of it
         * @param checkEvery how many frames from one check to the next
         */
        public function SoakGame(seed:uint, checkEvery:int)
        {
            _checkEvery = checkEvery;
            _random = new SeededRandom(seed);
            _models = new SoakModels(_random, _counts);
            _systems = new SoakSystems(_random, _models.greatLand);
            _check = new SoakCheck(_models, _systems, _counts);
            _collision = new Collision(_systems.next());
            _other = new Collision(new TightestFitCollider(_models.greatLand));
            _other.onCollision(Collision.ANY_BREED, "bears", countOther);
            _witness = new SoakWitness(_collision, _models);
            _touches = new <SoakTouches>[new SoakTouches(_collision, _counts, _witness, "bears", "balls"),
                    new SoakTouches(_collision, _counts, _witness, "walls", "walls")];
            _ground = new SoakGround(_collision, _random, _counts, _witness);
            while (_agents.length < FEWEST)
            {
                addAgent();
            }
            addHandler();
        }

        /** What has happened. */
        public function get counts():SoakCounts
        {
            return _counts;
        }

        /** A hash of all that the game has seen so far: eight hexadecimal digits. */
        public function get hash():String
        {
            return _witness.toString();
        }

        /**
         * Plays a frame.
         *
         * @throws Error about what should not have happened
         */
        public function play():void
        {
            _frame++;
            _isChecking = _frame % _checkEvery == 0;
            _isCalm = (_frame + 1) % _checkEvery == 0;
            changeTheWorld();
            for each (var agent:Agent in _agents.concat())
            {
                move(agent);
            }
            var isGone:Boolean = isAnyModelGone();
            if (isGone && (_isChecking || _isCalm || _random.chance(0.5)))
            {
                reshapeTheLost();
                isGone = false;
            }
            if (_isCalm)
            {
                _check.remember(_agents);
            }
            else if (_isChecking)
            {
                _check.begin(_agents);
            }
            update(isGone);
            _witness.seeFrame(_agents, isAnyModelGone());
            if (_isChecking)
            {
                endCheck();
            }
        }

        private function update(isGone:Boolean):void
        {
            var name:String = pairsOf(_systems.name);
            _thrown = 0;
            try
            {
                _collision.update(_agents);
            }
            catch (error:Error)
            {
                takeError(error, isGone);
                isGone = false;
            }
            require(!isGone, "an agent's model was gone, and no error came");
            require(_collision.handlerErrors.length == _thrown, "handlers threw " + _thrown + " errors, not: " + _collision.handlerErrors);
            _counts.add(name, _collision.statistics.collisions);
            _counts.add("handler calls", _collision.statistics.handlerCalls);
            _counts.add("agents whose model is loading", _collision.statistics.agentsLoading);
        }

        private function takeError(error:Error, isGone:Boolean):void
        {
            if (isGone)
            {
                require(error is ArgumentError && error.message.indexOf("there is no model") > 0, error.message);
                _counts.add("errors for models that are gone, as they should");
                reshapeTheLost();
                return;
            }
            require(_collision.handlerErrors.indexOf(error) == 0, error.message);
            for each (var each:Error in _collision.handlerErrors)
            {
                require(each.message.indexOf(MEANT + " (") == 0, each.message);
            }
            _counts.add("errors of handlers, as they should", _thrown);
        }

        private function endCheck():void
        {
            var problem:String = _check.verdict(Collider(_collision.collisionSystem), _handlers);
            require(problem == "", problem);
            exchangeSystem();
        }

        private function require(isRight:Boolean, problem:String):void
        {
            if (!isRight)
            {
                throw new Error("frame " + _frame + ": " + problem);
            }
        }

        private function changeTheWorld():void
        {
            if (_agents.length < MOST && _random.chance(_agents.length < FEWEST ? 0.9 : 0.3))
            {
                addAgent();
            }
            if (_agents.length > FEWEST && _random.chance(0.3))
            {
                removeAgent(_random.pick(toArray(_agents)));
            }
            if (_isChecking)
            {
                return;
            }
            changeHandlers();
            _ground.change();
            if (_random.chance(0.03))
            {
                exchangeSystem();
            }
            if (_random.chance(0.1))
            {
                _models.loadOne();
            }
            if (_random.chance(0.05))
            {
                _models.replaceOne();
            }
            if (_random.chance(0.05))
            {
                _models.removeOne();
            }
        }

        private function changeHandlers():void
        {
            if (_random.chance(0.1))
            {
                addHandler();
            }
            if (_random.chance(0.1))
            {
                removeHandler();
            }
            for each (var touches:SoakTouches in _touches)
            {
                if (_random.chance(0.02))
                {
                    touches.toggle();
                }
            }
        }

        private function exchangeSystem():void
        {
            _collision.collisionSystem = _systems.next();
            _counts.add("systems exchanged");
        }

        private function addAgent():void
        {
            var agent:Agent = new Agent(_models.pickShape(), _random.pick(BREEDS));
            agent.moveTo(_random.between(-6, 6), _random.between(-6, 6), _random.between(-1, 1));
            agent.size = pickSize();
            agent.sweeps = _random.chance(0.2);
            agent.hierarchical = _random.chance(0.3);
            agent.traversalDepth = _random.integer(0, 6);
            agent.collideAs = _random.pick([Agent.TIGHTEST, Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE]);
            _agents.splice(_random.integer(0, _agents.length), 0, agent);
            _counts.add("agents added");
        }

        private function removeAgent(agent:Agent):void
        {
            var place:int = _agents.indexOf(agent);
            if (place >= 0)
            {
                _agents.splice(place, 1);
                _counts.add("agents removed");
            }
        }

        // Towards the middle, so that nobody gets lost.
        private function move(agent:Agent):void
        {
            var speed:Number = _random.pick([0, 0, 0.1, 0.5, 2]);
            if (speed == 0)
            {
                return;
            }
            var x:Number = agent.x * 0.98 + speed * bell();
            var y:Number = agent.y * 0.98 + speed * bell();
            var z:Number = agent.z * 0.9 + 0.1 * speed * bell();
            if (_random.chance(0.02))
            {
                agent.jumpTo(x, y, z);
                _check.forget(agent);
                _counts.add("jumps");
            }
            else
            {
                agent.moveTo(x, y, z);
            }
            if (_random.chance(0.1))
            {
                changeTrait(agent);
            }
        }

        private function changeTrait(agent:Agent):void
        {
            switch (_random.integer(0, 4))
            {
                case 0:
                    agent.size = pickSize();
                    _counts.add("agents resized");
                    break;
                case 1:
                    reshape(agent);
                    break;
                case 2:
                    agent.heading = _random.between(0, 360);
                    agent.pitch = _random.pick([0, 30]);
                    agent.roll = _random.pick([0, 200]);
                    _counts.add("agents turned");
                    break;
                case 3:
                    agent.sweeps = !agent.sweeps;
                    _counts.add("agents that begin or cease to sweep");
                    break;
                default:
                    agent.breed = _random.pick(BREEDS);
                    _counts.add("agents of another breed");
            }
        }

        private function reshape(agent:Agent):void
        {
            agent.shape = _models.pickShape();
            _counts.add("agents reshaped");
        }

        // SeededRandom's own need logarithms, which are not the same on every machine

        private function pickSize():Number
        {
            var root:Number = _random.between(0.55, 1.73);
            return root * root;
        }

        private function bell():Number
        {
            return 2 * (_random.next() + _random.next() + _random.next() - 1.5);
        }

        private function isAnyModelGone():Boolean
        {
            return _agents.some(function(agent:Agent, index:int, all:Vector.<Agent>):Boolean
                {
                    return !_models.isKnown(agent.shape);
                });
        }

        private function reshapeTheLost():void
        {
            for each (var agent:Agent in _agents)
            {
                if (!_models.isKnown(agent.shape))
                {
                    reshape(agent);
                }
            }
        }

        private function addHandler():void
        {
            if (_handlers.length >= MOST_HANDLERS)
            {
                return;
            }
            var handler:SoakHandler = new SoakHandler(_random.pick(BREEDS.concat(Collision.ANY_BREED)),
                    _random.pick(BREEDS.concat(Collision.ANY_BREED)));
            handler.call = _random.chance(0.3) ? withContact : withoutContact;
            _collision.onCollision(handler.breed, handler.otherBreed, handler.call);
            _handlers.push(handler);
            _counts.add("handlers added");

            function withContact(collider:Agent, collidee:Agent, contact:Contact):void
            {
                require(contact.time >= 0 && contact.time <= 1 && Math.abs(contact.normal.length - 1) < 1e-9, "contact " + contact.normal);
                _witness.seeContact(collider, collidee, contact);
                call(handler, collider, collidee);
            }

            function withoutContact(collider:Agent, collidee:Agent):void
            {
                _witness.seePair(collider, collidee);
                call(handler, collider, collidee);
            }
        }

        private function removeHandler():void
        {
            if (_handlers.length > 1)
            {
                var handler:SoakHandler = _handlers.splice(_random.integer(0, _handlers.length - 1), 1)[0];
                require(_collision.removeHandler(handler.breed, handler.otherBreed, handler.call), "a handler was not there");
                _counts.add("handlers removed");
            }
        }

        private function call(handler:SoakHandler, collider:Agent, collidee:Agent):void
        {
            if (_isChecking)
            {
                _check.note(handler, collider, collidee, Collider(_collision.collisionSystem));
            }
            else if (_random.chance(0.02))
            {
                _counts.add("calls that changed the game");
                act(collider, collidee);
            }
            if (_random.chance(0.001))
            {
                _thrown++;
                throw new Error(MEANT);
            }
        }

        private function act(collider:Agent, collidee:Agent):void
        {
            switch (_random.integer(0, 9))
            {
                case 0:
                    removeAgent(collidee);
                    break;
                case 1:
                    removeAgent(collider);
                    break;
                case 2:
                    addAgent();
                    break;
                case 3:
                    addHandler();
                    break;
                case 4:
                    removeHandler();
                    break;
                case 5:
                    updateOther();
                    break;
                case 6:
                    actOnTheWorld();
                    break;
                case 7:
                    move(collider);
                    break;
                default:
                    changeTrait(collidee);
            }
        }

        private function actOnTheWorld():void
        {
            if (_isCalm)
            {
                return;
            }
            switch (_random.integer(0, 3))
            {
                case 0:
                    exchangeSystem();
                    break;
                case 1:
                    _models.replaceOne();
                    break;
                case 2:
                    _models.removeOne();
                    break;
                default:
                    _models.loadOne();
            }
        }

        // A game may have two Collisions; the one's handler may update the other.
        private function updateOther():void
        {
            if (!isAnyModelGone())
            {
                _other.update(_agents);
            }
        }

        private function countOther(collider:Agent, collidee:Agent):void
        {
            _counts.add("calls of another Collision");
        }

        private static function countedThings():Array
        {
            var names:Array = ["agents added", "agents removed", "agents resized", "agents reshaped", "agents turned",
                    "agents of another breed", "jumps", "agents that begin or cease to sweep", "agents whose model is loading",
                    "models added", "models replaced", "models removed", "models loaded", "fits read", "fits read damaged", "loads cancelled", "loads failed, as they should",
                    "systems exchanged", "handlers added", "handlers removed", "handler calls", "calls that changed the game",
                    "errors of handlers, as they should", "errors for models that are gone, as they should",
                    "calls of another Collision", "starts of touches", "ends of touches", "frames checked", "pairs checked",
                    "collisions confirmed", "pairs checked along their ways", "collisions on ways confirmed"];
            for each (var system:String in SoakSystems.NAMES)
            {
                names.push(pairsOf(system));
            }
            return names.concat(SoakGround.COUNTED);
        }

        private static function pairsOf(system:String):String
        {
            return "pairs found by the " + system;
        }

        private static function toArray(agents:Vector.<Agent>):Array
        {
            var array:Array = [];
            for each (var agent:Agent in agents)
            {
                array.push(agent);
            }
            return array;
        }
    }
}

package starlogo.agents
{
    import starlogo.engine;

    use namespace engine;

    /**
     * A character or thing of the game, with the client's built-in traits. An AgentBody has its place, its turn and its size.
     *
     * <p>A trait that gets a value that it can't have throws an error that names the agent, and keeps its value.</p>
     */
    public class Agent extends AgentBody
    {
        /**
         * The largest coordinate, in patches: squares of distances stay far from what a Number can hold, and all tests are
         * right up to it.
         */
        public static const LARGEST_COORDINATE:Number = 1e9;

        /** The largest size. */
        public static const LARGEST_SIZE:Number = 1e6;

        /** The smallest size. */
        public static const SMALLEST_SIZE:Number = 1e-6;

        /** For <code>collideAs</code>: the tightest of all. */
        public static const TIGHTEST:String = "tightest";

        /** For <code>collideAs</code>. */
        public static const SPHERE:String = "sphere";

        /** For <code>collideAs</code>. */
        public static const BOX:String = "box";

        /** For <code>collideAs</code>. */
        public static const CAPSULE:String = "capsule";

        // by the numbers of the kinds in BoundingStructure
        private static const NAMES_OF_KINDS:Vector.<String> = new <String>[SPHERE, CAPSULE, BOX];

        /** @private Whether any agent has ever swept: while none has, colliders need not look for those that do. */
        engine static var haveSwept:Boolean = false;

        /** @private The number of the breed's name. */
        engine var breedNumber:int;

        /** @private For <code>structureKind</code>: the tightest structure, of whatever kind. */
        engine static const ANY_KIND:int = -1;

        private static var sCreated:int = 0;

        /** @private The value of <code>id</code>, without a call. */
        engine var number:int;

        /** @private Counts the changes of the agent's shape and of how it collides. */
        engine var shapeRevision:int = 0;

        /** @private The value of <code>traversalDepth</code>, without a call. */
        engine var depthLimit:int = 0;

        /** @private The value of <code>sweeps</code>, without a call. */
        engine var isSweeping:Boolean = false;

        /** @private The kind of structure that represents the agent, ANY_KIND for the tightest. */
        engine var structureKind:int = ANY_KIND;

        /** The agent's colour, as the client counts colours. Collisions do not depend on it. */
        public var color:Number = 0;

        private var _shape:String;
        private var _breed:String;
        private var _hierarchical:Boolean = false;

        /**
         * An agent of size 1 at the origin.
         *
         * @param shape the name of its model; the colliders' GreatLand must have it
         * @param breed the name of its breed
         * @throws ArgumentError if either is null or empty
         */
        public function Agent(shape:String, breed:String = "turtles")
        {
            super();
            requireName("shape", shape);
            requireBreed(breed);
            number = ++sCreated;
            _shape = shape;
            takeBreed(breed);
        }

        /** @private Gives its id back, because it is the engine's own, in no list, and the last that was made. It is 0 then. */
        engine function giveIdBack():void
        {
            number = 0;
            sCreated--;
        }

        /** @private How many agents there have been: the greatest id. */
        engine static function get createdCount():int
        {
            return sCreated;
        }

        /** A number that no other agent of this run has; the first is 1. */
        public function get id():int
        {
            return number;
        }

        /** The name of the agent's model. */
        public function get shape():String
        {
            return _shape;
        }

        public function set shape(value:String):void
        {
            requireName("shape", value);
            if (value != _shape)
            {
                _shape = value;
                shapeRevision++;
                extentsChanged();
            }
        }

        /** The name of the agent's breed. */
        public function get breed():String
        {
            return _breed;
        }

        public function set breed(value:String):void
        {
            requireBreed(value);
            if (value != _breed)
            {
                takeBreed(value);
            }
        }

        /** @private Makes the breed any, without a question. */
        engine function takeBreed(value:String):void
        {
            _breed = value;
            breedNumber = Breeds.numberOf(value);
        }

        /**
         * Whether a CombinationCollider uses the agent's hierarchy rather than its tightest fit (thesis §5.2). May
         * change between frames.
         */
        public function get hierarchical():Boolean
        {
            return _hierarchical;
        }

        public function set hierarchical(value:Boolean):void
        {
            if (value != _hierarchical)
            {
                _hierarchical = value;
                shapeRevision++;
                extentsChanged();
            }
        }

        /**
         * How many levels of this agent's hierarchy a collision test visits, the root being level 1 (thesis §4.6); 0
         * leaves it to the collider's maxDepth.
         *
         * @throws RangeError if set to a negative number
         */
        public function get traversalDepth():int
        {
            return depthLimit;
        }

        public function set traversalDepth(value:int):void
        {
            if (value < 0)
            {
                throw new RangeError(this + ": traversalDepth must not be negative, but was " + value);
            }
            if (value != depthLimit)
            {
                depthLimit = value;
                extentsChanged();
            }
        }

        /**
         * Which structure around its model represents the agent in the TightestFitCollider and, while it is not hierarchical, in the
         * CombinationCollider: TIGHTEST, or the smallest SPHERE, BOX or CAPSULE (thesis §7.3). May change between frames. One that was not kept
         * when the model was added (loadAllBoundingStructures) is found when a collider first needs it, which takes as long as adding the model
         * does.
         *
         * @throws ArgumentError if set to anything else
         */
        public function get collideAs():String
        {
            if (structureKind == ANY_KIND)
            {
                return TIGHTEST;
            }
            return NAMES_OF_KINDS[structureKind];
        }

        public function set collideAs(value:String):void
        {
            // ANY_KIND for TIGHTEST, which is no kind's name
            var kind:int = NAMES_OF_KINDS.indexOf(value);
            if (kind == ANY_KIND && value != TIGHTEST)
            {
                throw new ArgumentError(this + ": collideAs must be \"tightest\", \"sphere\", \"box\" or \"capsule\", not "
                        + (value == null ? "null" : "\"" + value + "\""));
            }
            if (kind != structureKind)
            {
                structureKind = kind;
                shapeRevision++;
                extentsChanged();
            }
        }

        /**
         * Whether the agent collides with everything that it met as it moved since the last frame, not only with what it overlaps now: so
         * that it flies through nothing, however fast it is.
         *
         * <p>The motion is the straight line from where the collider saw the agent in its last frame to where it is, both ends included. The
         * other agent's own motion counts, whether that sweeps or not: the relative motion of the two is tested. Turns and size count as they are
         * now. An agent has no motion in the first frame that a collider sees it in, after a change of its shape, after <code>jumpTo()</code>,
         * after a frame whose list did not have it, and while its model was loading: in that frame it is tested only where it is.</p>
         */
        public function get sweeps():Boolean
        {
            return isSweeping;
        }

        public function set sweeps(value:Boolean):void
        {
            isSweeping = value;
            haveSwept = haveSwept || value;
        }

        /** The class, id, breed and shape: how errors name the agent. */
        override public function toString():String
        {
            if (_shape == null)
            {
                return super.toString();
            }
            return "agent " + number + " (breed \"" + _breed + "\", shape \"" + _shape + "\")";
        }

        private function requireBreed(value:String):void
        {
            requireName("breed", value);
            if (Breeds.isReserved(Breeds.numberOf(value)) || (_breed != null && Breeds.isReserved(breedNumber)))
            {
                throw new ArgumentError(this + ": breed must not be \"" + value + "\": only the ground and the edges of the world have such a breed, and they keep it");
            }
        }

        private function requireName(trait:String, value:String):void
        {
            if (value == null || value == "")
            {
                throw new ArgumentError(this + ": " + trait + " must be a name, not " + (value == null ? "null" : "\"\""));
            }
        }
    }
}

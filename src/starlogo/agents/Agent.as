package starlogo.agents
{
    import starlogo.engine;

    use namespace engine;

    /**
     * A character or thing of the game, with the client's built-in traits. Its place, turn and size are properties of AgentBody.
     *
     * <p>If you set a trait to a value that is not allowed, it throws an error that names the agent. The trait then keeps its old
     * value.</p>
     */
    public class Agent extends AgentBody
    {
        /**
         * The largest coordinate, in patches. Up to this limit all tests are correct, because squares of distances are far below the
         * largest Number.
         */
        public static const LARGEST_COORDINATE:Number = 1e9;

        /** The largest size. */
        public static const LARGEST_SIZE:Number = 1e6;

        /** The smallest size. */
        public static const SMALLEST_SIZE:Number = 1e-6;

        /** For <code>collideAs</code>: the structure with the smallest volume. */
        public static const TIGHTEST:String = "tightest";

        /** For <code>collideAs</code>: the smallest sphere. */
        public static const SPHERE:String = "sphere";

        /** For <code>collideAs</code>: the smallest box. */
        public static const BOX:String = "box";

        /** For <code>collideAs</code>: the smallest capsule. */
        public static const CAPSULE:String = "capsule";

        // the index is the number of a kind in BoundingStructure
        private static const NAMES_OF_KINDS:Vector.<String> = new <String>[SPHERE, CAPSULE, BOX];

        /** @private Whether any agent has ever swept. As long as none has, colliders need not look for sweeping agents. */
        engine static var haveSwept:Boolean = false;

        /** @private The number of the breed's name. */
        engine var breedNumber:int;

        /** @private For <code>structureKind</code>: the tightest structure of any kind. */
        engine static const ANY_KIND:int = -1;

        private static var sCreated:int = 0;

        /** @private The value of <code>id</code>, without a call. */
        engine var number:int;

        /** @private Counts changes of the agent's shape and of the way it collides. */
        engine var shapeRevision:int = 0;

        /** @private The value of <code>traversalDepth</code>, without a call. */
        engine var depthLimit:int = 0;

        /** @private The value of <code>sweeps</code>, without a call. */
        engine var isSweeping:Boolean = false;

        /** @private The kind of structure for the agent; ANY_KIND for the tightest. */
        engine var structureKind:int = ANY_KIND;

        /** The agent's colour, with the client's colour numbers. It has no effect on collisions. */
        public var color:Number = 0;

        private var _shape:String;
        private var _breed:String;
        private var _hierarchical:Boolean = false;

        /**
         * Creates an agent of size 1 at the origin.
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

        /**
         * @private Gives the agent's id back. Its id is 0 then. Call it only for an agent of the engine that is in no list and was created
         * last.
         */
        engine function giveIdBack():void
        {
            number = 0;
            sCreated--;
        }

        /** @private The number of agents created so far, which is also the largest id. */
        engine static function get createdCount():int
        {
            return sCreated;
        }

        /** A number that no other agent of this run has. The first is 1. */
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

        /** @private Sets the breed to any name, without a check. */
        engine function takeBreed(value:String):void
        {
            _breed = value;
            breedNumber = Breeds.numberOf(value);
        }

        /**
         * Whether a CombinationCollider uses the agent's hierarchy instead of its tightest fit (thesis §5.2). May change between frames.
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
         * The number of levels of this agent's hierarchy that a collision test visits (thesis §4.6). The root is level 1. With 0, the
         * collider's maxDepth decides.
         *
         * @throws RangeError if you set it to a negative number
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
         * The bounding structure that the agent collides as: TIGHTEST, or the smallest SPHERE, BOX or CAPSULE (thesis §7.3). It counts in
         * the TightestFitCollider, and in the CombinationCollider if the agent is not hierarchical. May change between frames. If the
         * structure was not kept when the model was added (loadAllBoundingStructures), it is computed when a collider first needs it. This
         * takes as long as adding the model.
         *
         * @throws ArgumentError if you set it to anything else
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
            // ANY_KIND for TIGHTEST, which is no name of a kind
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
         * Whether the agent collides with everything that it met during its motion since the last frame. Then it cannot pass through
         * anything, no matter how fast it is. Otherwise it collides only with what it overlaps now.
         *
         * <p>The motion is the straight line from the place where the collider saw the agent in its last frame to its present place. Both
         * ends are included. The engine tests the relative motion of two agents, so the other agent's motion counts too, whether that one
         * sweeps or not. Turns and size count as they are now. In some frames an agent has no motion and is tested only at its present
         * place. These are the first frame in which a collider sees it, and the first frame after a change of its shape, after
         * <code>jumpTo()</code>, after a frame whose list did not have it, or after a frame in which its model was loading.</p>
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

        /** The class, id, breed and shape, as errors name the agent. */
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

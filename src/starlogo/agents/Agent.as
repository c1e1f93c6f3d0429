// This room has what a game moves: agents, how they are turned (Turn), which values they refuse (TraitChecks), and the numbers of the names of their
// breeds and models (NameNumbers). The rooms from search on read it. Read this file first.
// This file is long because an agent has many traits, and each one's contract stands at the trait.
package starlogo.agents
{
    import flash.geom.Matrix3D;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * A character or thing of the game, with the client's built-in traits.
     *
     * <p>The world is right-handed with z up. Lengths are in patches, angles in degrees. To place an agent, its model is scaled by
     * <code>size</code>, then turned about the world's axes: by <code>roll</code> about x, <code>pitch</code> about y and
     * <code>heading</code> about z. Then it is moved to (x, y, z). All this is relative to the model's origin, which is its centre in x and
     * y and its lowest point in z (thesis §2.2, §3.5). A model that is AS_GIVEN has the origin of its vertices, which may be anywhere.</p>
     *
     * <p>If you set a trait to a value that is not allowed, it throws an error that names the agent. The trait then keeps its old
     * value.</p>
     */
    public class Agent
    {
        /**
         * The largest coordinate, in patches: 1e9. Up to this limit all tests are correct, because squares of distances are far below the
         * largest Number.
         */
        public static const LARGEST_COORDINATE:Number = Placement.LARGEST_COORDINATE;

        /** The largest size: 1e6. */
        public static const LARGEST_SIZE:Number = 1e6;

        /** The smallest size: 1e-6. */
        public static const SMALLEST_SIZE:Number = 1e-6;

        /** For <code>collideAs</code>: the structure with the smallest volume. */
        public static const TIGHTEST:String = "tightest";

        /** For <code>collideAs</code>: the smallest sphere. */
        public static const SPHERE:String = "sphere";

        /** For <code>collideAs</code>: the smallest box. */
        public static const BOX:String = "box";

        /** For <code>collideAs</code>: the smallest capsule. */
        public static const CAPSULE:String = "capsule";

        /** For <code>collideAs</code>: a convex hull of few corners; the smallest sphere if that is not larger. */
        public static const HULL:String = "hull";

        /** @private Names of structures. The index is the number of a kind in BoundingStructure. */
        engine static const STRUCTURE_NAMES:Vector.<String> = new <String>[SPHERE, CAPSULE, BOX, HULL];

        /** @private For <code>structureKind</code>: the tightest structure of any kind. */
        engine static const ANY_KIND:int = -1;

        /** @private The numbers of the names of models. */
        engine static const MODEL_NAMES:NameNumbers = new NameNumbers(new Vector.<String>());

        /** @private The number of agents and terrains created so far, which is also the largest id. */
        engine static var createdCount:int = 0;

        private static var sMatrix:Vector.<Number> = new Matrix3D().rawData;

        /** @private The agent's place in the world. Its rotation may be stale: see <code>freshPlacement</code>. */
        engine var placement:Placement = new Placement();

        /**
         * @private Counts changes of all that a search reads: what <code>bodyRevision</code> counts, the place, the breed, and whether the
         * agent sweeps; and for the agents of the ground and the edges, changes of these.
         */
        engine var revision:int = 0;

        /**
         * @private Counts changes of the agent's body, except of its place: of the model, the way it collides, the turn, the size, and
         * <code>traversalDepth</code>.
         */
        engine var bodyRevision:int = 0;

        /** @private The revision that the last jump made, or 0. No motion of the agent begins before it. */
        engine var jumpRevision:int = 0;

        /** @private The value of <code>id</code>, without a call. */
        engine var idNumber:int;

        /** @private The number of the breed's name. */
        engine var breedNumber:int;

        /** @private The number of the model's name in MODEL_NAMES. */
        engine var modelNumber:int;

        /** @private The value of <code>traversalDepth</code>, without a call. */
        engine var depthLimit:int = 0;

        /** @private The value of <code>sweeps</code>, without a call. */
        engine var isSweeping:Boolean = false;

        /** @private The value of <code>hierarchical</code>, without a call. */
        engine var isHierarchical:Boolean = false;

        /** @private The kind of structure for the agent; ANY_KIND for the tightest. */
        engine var structureKind:int = ANY_KIND;

        /** @private What the agent stands on since its last walk. It is null before the first walk. */
        engine var platformLink:PlatformLink = null;

        /**
         * Whether the agent stops only what comes from above: a platform to jump up through and to stand on. It counts for others that walk, slide,
         * move until they touch, or are cast (<code>AgentQueries</code>). It stops them only with surfaces that are no steeper than 45 degrees, and
         * only if they are above it or rest on it when their motion begins. From below, from the side and from within they pass, and
         * <code>walk()</code> does not push them out, but lifts who was above it before it moved up into them. Collisions, rays and all other
         * questions are not affected. It counts from the next question on.
         *
         * @default false
         */
        public var isOneWay:Boolean = false;

        /** The agent's colour, with the client's colour numbers. It has no effect on collisions. */
        public var color:Number = 0;

        private var _turn:Turn = null;

        /**
         * Creates an agent of size 1 at the origin.
         *
         * @param shape the name of its model; the colliders' GreatLand must have it
         * @param breed the name of its breed, the group that handlers name; without it, the breed is "turtles"
         * @throws ArgumentError if either is null or empty, or if the breed is reserved: <code>Collision.ANY_BREED</code>, <code>TERRAIN</code> and <code>EDGE</code>
         */
        public function Agent(shape:String, breed:String = "turtles")
        {
            TraitChecks.requireName(this, "shape", shape);
            TraitChecks.requireBreed(this, breed);
            idNumber = newId();
            breedNumber = Breeds.NAMES.numberOf(breed);
            modelNumber = MODEL_NAMES.numberOf(shape);
        }

        /** @private Counts a new agent, and returns its id. */
        engine static function takeId():int
        {
            return ++createdCount;
        }

        /** @private Whether an agent may have a size. */
        engine static function isSize(value:Number):Boolean
        {
            return value >= SMALLEST_SIZE && value <= LARGEST_SIZE;
        }

        /** @private The id of a new agent. */
        engine function newId():int
        {
            return takeId();
        }

        /** @private Whether it stands for the ground or the edges of the world. */
        engine function get isEnvironment():Boolean
        {
            return Breeds.isEnvironment(breedNumber);
        }

        /** A number that no other agent of this run has. The first is 1. Those of the edges of the world have negative numbers. */
        public function get id():int
        {
            return idNumber;
        }

        /** The name of the agent's model. */
        public function get shape():String
        {
            return MODEL_NAMES.nameOf(modelNumber);
        }

        public function set shape(value:String):void
        {
            TraitChecks.requireName(this, "shape", value);
            var other:int = MODEL_NAMES.numberOf(value);
            if (other != modelNumber)
            {
                modelNumber = other;
                countBodyChange();
            }
        }

        /** The name of the agent's breed. @throws ArgumentError as the constructor */
        public function get breed():String
        {
            return Breeds.NAMES.nameOf(breedNumber);
        }

        public function set breed(value:String):void
        {
            TraitChecks.requireBreed(this, value);
            var other:int = Breeds.NAMES.numberOf(value);
            if (other != breedNumber)
            {
                breedNumber = other;
                revision++;
                Breeds.countChange();
            }
        }

        /** The place of the model's origin along the world's x axis, from -LARGEST_COORDINATE to LARGEST_COORDINATE. */
        public function get x():Number
        {
            return placement.x;
        }

        public function set x(value:Number):void
        {
            moveTo(value, placement.y, placement.z);
        }

        /** The place of the model's origin along the world's y axis, from -LARGEST_COORDINATE to LARGEST_COORDINATE. */
        public function get y():Number
        {
            return placement.y;
        }

        public function set y(value:Number):void
        {
            moveTo(placement.x, value, placement.z);
        }

        /**
         * The place of the model's origin along z, which is up, from -LARGEST_COORDINATE to LARGEST_COORDINATE. For an upright
         * agent, the origin is its lowest point, unless its model is AS_GIVEN.
         */
        public function get z():Number
        {
            return placement.z;
        }

        public function set z(value:Number):void
        {
            moveTo(placement.x, placement.y, value);
        }

        /** The turn about the z axis in degrees, counter-clockwise seen from above. Any finite number. */
        public function get heading():Number
        {
            return turn.updateAngles().heading;
        }

        public function set heading(value:Number):void
        {
            var before:Turn = turn.updateAngles();
            turnTo(value, before.pitch, before.roll);
        }

        /** The turn about the world's y axis in degrees, before the heading. Any finite number. */
        public function get pitch():Number
        {
            return turn.updateAngles().pitch;
        }

        public function set pitch(value:Number):void
        {
            var before:Turn = turn.updateAngles();
            turnTo(before.heading, value, before.roll);
        }

        /** The turn about the world's x axis in degrees, before the pitch. Any finite number. */
        public function get roll():Number
        {
            return turn.updateAngles().roll;
        }

        public function set roll(value:Number):void
        {
            var before:Turn = turn.updateAngles();
            turnTo(before.heading, before.pitch, value);
        }

        /** The uniform scale of the model, from SMALLEST_SIZE to LARGEST_SIZE. With 1 the agent is one patch wide. */
        public function get size():Number
        {
            return placement.size;
        }

        public function set size(value:Number):void
        {
            TraitChecks.requireSize(this, value);
            if (value != placement.size)
            {
                placement.size = value;
                countBodyChange();
            }
        }

        /**
         * Moves the agent to a place without a motion. A sweeping agent meets nothing on the way.
         *
         * @param x as in moveTo
         * @param y as in moveTo
         * @param z as in moveTo
         * @throws RangeError as in moveTo
         */
        public function jumpTo(x:Number, y:Number, z:Number):void
        {
            var before:int = revision;
            moveTo(x, y, z);
            // a jump counts even if the place is the same
            revision = before + 1;
            jumpRevision = revision;
        }

        /**
         * Moves the agent to a place. One call replaces setting x, y and z. If it is there already, nothing changes.
         *
         * @param x patches, from -LARGEST_COORDINATE to LARGEST_COORDINATE
         * @param y as x
         * @param z as x
         * @throws RangeError if one is not finite, or beyond LARGEST_COORDINATE; the agent then stays where it was
         */
        public function moveTo(x:Number, y:Number, z:Number):void
        {
            // LARGEST_COORDINATE squared; the comparison is false for NaN too
            if (!(x * x + y * y + z * z <= 1e18))
            {
                TraitChecks.requirePlace(this, x, y, z);
            }
            var at:Placement = placement;
            if (x == at.x && y == at.y && z == at.z)
            {
                return;
            }
            // plus 0, because -0 becomes 0: places that are equal have the same bits, also in snapshots
            at.x = x + 0;
            at.y = y + 0;
            at.z = z + 0;
            revision++;
        }

        /**
         * A new matrix that transforms the model's space to the world. Use <code>getMatrix()</code> to write into an existing matrix
         * instead.
         */
        public function get transform():Matrix3D
        {
            return getMatrix();
        }

        /**
         * Turns the agent by a quaternion. It loses nothing when heading and roll turn about the same axis. Afterwards heading, pitch and
         * roll are angles that give the same rotation, with the pitch between -90 and 90. If the agent had this rotation already, its
         * angles stay as they are. If you then set one of them, the three angles make the rotation again.
         *
         * @param x of the quaternion x i + y j + z k + w; it may have any length but 0
         * @param y of the same quaternion
         * @param z of the same quaternion
         * @param w of the same quaternion
         * @throws RangeError if one is not finite, or all are 0; the agent is then unchanged
         */
        public function setQuaternion(x:Number, y:Number, z:Number, w:Number):void
        {
            turnBy(x, y, z, w);
        }

        /**
         * The unit quaternion of the agent's rotation. If <code>setQuaternion()</code> has set the rotation, and its numbers had the length 1 up to
         * a millionth, these are the same numbers to the last bit; if they had another length, these are the numbers divided by it. If angles or a
         * matrix made the rotation, w is not negative. Given to <code>setQuaternion()</code> again, the
         * numbers make the same rotation to the last bit if <code>setQuaternion()</code> or <code>setMatrix()</code> has made it.
         *
         * @param out takes x, y, z, w; created if null
         * @return out
         */
        public function getQuaternion(out:Vector.<Number> = null):Vector.<Number>
        {
            out ||= new Vector.<Number>(4);
            turn.readQuaternion(out);
            return out;
        }

        /**
         * Moves, turns and scales the agent by a matrix. <code>transform</code> returns such a matrix. Flash Player stores a Matrix3D in
         * single precision, which rounds each number by up to 1e-7 of its size. The methods setQuaternion and moveTo and the property size keep
         * full precision.
         *
         * @param matrix from the model's space to the world; it may rotate, scale uniformly and translate
         * @throws ArgumentError if it is null, or mirrors, shears, or scales non-uniformly
         * @throws RangeError if an agent can't have the place or the size. After either error the agent is unchanged
         */
        public function setMatrix(matrix:Matrix3D):void
        {
            if (matrix == null)
            {
                throw new ArgumentError(this + ": matrix must not be null");
            }
            var data:Vector.<Number> = matrix.rawData;
            var found:Placement = new Placement();
            if (!found.setMatrix(data))
            {
                throw new ArgumentError(this + ": matrix must only turn, move and uniformly scale: " + data);
            }
            TraitChecks.requirePlace(this, found.x, found.y, found.z);
            size = found.size;
            moveTo(found.x, found.y, found.z);
            var quaternion:Vector.<Number> = new Vector.<Number>(4, true);
            found.readQuaternion(quaternion);
            setQuaternion(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
        }

        /**
         * The transform from the model's space to the world.
         *
         * @param out takes it; created if null
         * @return out
         */
        public function getMatrix(out:Matrix3D = null):Matrix3D
        {
            out ||= new Matrix3D();
            freshPlacement().readMatrix(sMatrix);
            out.copyRawDataFrom(sMatrix);
            return out;
        }

        /**
         * Whether a CombinationCollider uses the agent's hierarchy instead of its tightest fit (thesis §5.2). May change between frames.
         */
        public function get hierarchical():Boolean
        {
            return isHierarchical;
        }

        public function set hierarchical(value:Boolean):void
        {
            if (value != isHierarchical)
            {
                isHierarchical = value;
                countBodyChange();
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
                countBodyChange();
            }
        }

        /**
         * The bounding structure that the agent collides as: TIGHTEST, or the smallest SPHERE, BOX or CAPSULE (thesis §7.3), or a HULL. It
         * counts in the TightestFitCollider, and in the CombinationCollider if the agent is not hierarchical. May change between frames. A
         * hull that was not found when the model was added (loadHulls) is computed when a collider first needs it. This takes as long as
         * adding the model.
         *
         * @throws ArgumentError if you set it to anything else
         */
        public function get collideAs():String
        {
            if (structureKind == ANY_KIND)
            {
                return TIGHTEST;
            }
            return STRUCTURE_NAMES[structureKind];
        }

        public function set collideAs(value:String):void
        {
            // ANY_KIND for TIGHTEST, which is no name of a kind
            var kind:int = STRUCTURE_NAMES.indexOf(value);
            if (kind == ANY_KIND && value != TIGHTEST)
            {
                throw new ArgumentError(this + ": collideAs must be \"tightest\", \"sphere\", \"box\", \"capsule\" or \"hull\", not "
                        + (value == null ? "null" : "\"" + value + "\""));
            }
            if (kind != structureKind)
            {
                structureKind = kind;
                countBodyChange();
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
         * <code>jumpTo()</code>, after a frame whose list did not have it, or after a frame in which its model was loading; also the first frame
         * after <code>Collision.reset()</code>, or with another collider.</p>
         */
        public function get sweeps():Boolean
        {
            return isSweeping;
        }

        public function set sweeps(value:Boolean):void
        {
            if (value != isSweeping)
            {
                isSweeping = value;
                revision++;
            }
        }

        /** The class, id, breed and shape, as errors name the agent. */
        public function toString():String
        {
            if (idNumber == 0)
            {
                return "new Agent";
            }
            return "agent " + idNumber + " (breed \"" + breed + "\", shape \"" + shape + "\")";
        }

        /** @private <code>placement</code>, with the rotation brought up to date. */
        engine function freshPlacement():Placement
        {
            if (_turn != null)
            {
                _turn.updateRotation();
            }
            return placement;
        }

        /** @private How the agent is turned. It is made when it is first needed, because many agents are never turned. */
        engine function get turn():Turn
        {
            // not with ||=, which stores the turn again in each call
            if (_turn == null)
            {
                _turn = new Turn(placement);
            }
            return _turn;
        }

        /** @private Turns the agent by three angles. @throws RangeError if one is not finite; the agent is then unchanged */
        engine function turnTo(heading:Number, pitch:Number, roll:Number):void
        {
            TraitChecks.requireAngles(this, heading, pitch, roll);
            if (turn.setAngles(heading, pitch, roll))
            {
                countBodyChange();
            }
        }

        /** @private As setQuaternion(), which a game's subclass may override. */
        engine function turnBy(x:Number, y:Number, z:Number, w:Number):void
        {
            TraitChecks.requireQuaternion(this, x, y, z, w);
            if (turn.setQuaternion(x, y, z, w))
            {
                countBodyChange();
            }
        }

        /** @private Call it after a change that bodyRevision counts. */
        engine function countBodyChange():void
        {
            bodyRevision++;
            revision++;
        }
    }
}

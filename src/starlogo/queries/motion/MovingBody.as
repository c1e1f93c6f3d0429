// This folder moves a MovingBody among the rows of a table, which NearRows finds: a Slider along what it meets, a TouchFinder up to a touch. Both sweep
// each motion by a ShrunkSweep. It has a ShrunkBody, and a Depenetration that frees this from overlaps. The head of AgentMotions says in which order to
// read a walk.
// The words of this folder:
// Shrunk body: the body, but smaller, at first by a slop on each side (ShrunkBody). Only what it meets stops the body, so the body may touch what it
// stands on or runs along.
// Shallow overlap: one that can come from rounding in the game. A motion begins with pushes out of those (Depenetration), a walk with pushes out of
// deep ones too.
// Plane: it stands for a row that the body overlaps deeply, or out of which pushes do not lead, or that it has met on a slide. The motion must not
// cross it.
// Obstacles: the rows that can stop a motion. A row with a plane for an overlap is no obstacle, and neither is a one-way row that the body passes.
package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.isInWorld;
    import starlogo.geometry.requireInWorld;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.search.StructureBody;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * A body that moves and the rows near its way, for the classes that move it: they know rows only through it. It tests whether the body touches a
     * row, and how it overlaps the row, at the places that a motion tries.
     *
     * @private
     */
    public final class MovingBody
    {
        // A one-way row stops the body with surfaces whose normal has at least this z: no steeper than 45 degrees, and a little for rounding.
        private static const ONE_WAY_Z:Number = Math.SQRT1_2 - 1e-9;

        /** The body at its full size, not shrunk, where it was tested last. Only <code>moveTo()</code> moves it. Read only. */
        public var fullBody:Body = null;

        /** The rows that count and are near its way, in the order of the list. NearRows finds them. */
        public var rows:IntList = new IntList();

        /** The agent whose body it is, which does not count among the rows; null for the body of a structure. Read only. */
        public var agent:Agent = null;

        /** Where it begins, and the motion that is wanted. Read only. */
        public var from:Vector3D = new Vector3D();
        public var motion:Vector3D = new Vector3D();

        private var _seen:SeenAgents;

        // A copy of the body of an agent, because a filter's accepts may move the agent; and what makes the body of a structure.
        private var _copy:Body = new Body();
        private var _structureBody:StructureBody = new StructureBody();

        // Within passesOneWayAt().
        private var _oneWayContact:ContactPoint = new ContactPoint();

        /** @param seen has the rows, and decides which of them touch */
        public function MovingBody(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Becomes the body of an agent, as it is now.
         *
         * @return this body, as from all methods that make it another one
         * @throws ArgumentError if the agent is null, has no place, or its model is unknown or lacks data that is needed
         */
        public function setToAgent(agent:Agent):MovingBody
        {
            _seen.requirePlaced(agent);
            this.agent = agent;
            _copy.copyFrom(_seen.currentBodyOf(agent));
            return setFullBody(_copy);
        }

        /** Turns the body of an agent by some degrees. */
        public function turn(degrees:Number):void
        {
            if (degrees != 0 && hasShape)
            {
                fullBody.turn(agent, degrees);
            }
        }

        private function setFullBody(body:Body):MovingBody
        {
            fullBody = body;
            from.x = body.placement.x;
            from.y = body.placement.y;
            from.z = body.placement.z;
            return this;
        }

        /**
         * Becomes the body of an agent that is cast. A sphere, box, capsule or hull becomes the body of a structure, so that an agent and the same
         * structure meet the same, to the last bit.
         */
        public function setToCastAgent(agent:Agent):MovingBody
        {
            setToAgent(agent);
            return hasShape && fullBody.kind < ModelShape.TREE ? setFullBody(_structureBody.setTo(fullBody.shape.structure, fullBody.placement)) : this;
        }

        /** Becomes the body of a structure in the world. See <code>StructureBody.setTo()</code>. */
        public function setToStructure(structure:BoundingStructure):MovingBody
        {
            agent = null;
            return setFullBody(_structureBody.setTo(structure));
        }

        /** Sets the motion that is wanted. Returns this body. Throws a RangeError that names the first of the three that is not in the world. */
        public function aim(dx:Number, dy:Number, dz:Number):MovingBody
        {
            if (!isInWorld(dx, dy, dz))
            {
                requireInWorld("dx of a motion", dx, 0, 0, agent);
                requireInWorld("dy of a motion", 0, dy, 0, agent);
                requireInWorld("dz of a motion", 0, 0, dz, agent);
            }
            motion.x = dx;
            motion.y = dy;
            motion.z = dz;
            return this;
        }

        /** Whether it has a shape: false while the model of its agent is loading. */
        public function get hasShape():Boolean
        {
            return fullBody.shape != null;
        }

        /** Its largest extent. */
        public function get extent():Number
        {
            return 2 * fullBody.maxHalf;
        }

        /** The largest extent of the body and some rows. */
        public function largestExtentAmong(rows:IntList):Number
        {
            var largest:Number = extent;
            for (var i:int = 0; i < rows.count; i++)
            {
                largest = Math.max(largest, 2 * bodyOf(rows.values[i]).maxHalf);
            }
            return largest;
        }

        /** The body of a row. */
        public function bodyOf(row:int):Body
        {
            return _seen.table.bodyOf(row);
        }

        /** The tests of two bodies. */
        public function get narrowPhase():NarrowPhase
        {
            return _seen.narrowPhase;
        }

        /** The tests of this body, full or shrunk, with a row. */
        public function testsWith(row:int):PairTests
        {
            return narrowPhase.pairTestsFor(fullBody, bodyOf(row));
        }

        /** Moves the full body to a place. Returns the body, which stays there until the next call. */
        public function moveTo(place:Vector3D):Body
        {
            fullBody.moveTo(place);
            return fullBody;
        }

        /** Whether the full body touches a row when it stands at a place. */
        public function touches(row:int, place:Vector3D):Boolean
        {
            return narrowPhase.areTouching(moveTo(place), bodyOf(row));
        }

        /** Whether a row stops only what comes from above. See Agent.isOneWay. */
        public function isOneWay(row:int):Boolean
        {
            return _seen.table.listed.agentsByRow[row].isOneWay;
        }

        /** Whether the body goes on through a row that it meets with a contact: the row is one-way, and the body does not come from above. */
        public function passesOneWay(row:int, contact:ContactPoint):Boolean
        {
            return isOneWay(row) && contact.normalZ < ONE_WAY_Z;
        }

        /** The larger extent of the body and another. That of the ground is 0. */
        public function extentWith(other:Body):Number
        {
            return Math.max(2 * other.maxHalf, extent);
        }

        /**
         * Finds a contact of the full body with a row that it touches when it stands at a place.
         *
         * @param mustSeparate whether a push along the contact has to separate the two. Otherwise a shallow one may separate only two of their parts. The
         *     ground can be floor and wall at once, and a contact with one does not lead away from the other
         */
        public function findContact(row:int, place:Vector3D, mustSeparate:Boolean, out:ContactPoint):void
        {
            var other:Body = bodyOf(row);
            var tests:PairTests = testsWith(row);
            tests.findContactOfParts(moveTo(place), other, RelativeMotion.NONE, out);
            if (mustSeparate || !isShallow(row, out))
            {
                tests.separate(fullBody, other, RelativeMotion.NONE, out);
            }
        }

        /** Whether a contact with a row is so shallow that rounding in the game can be the cause. */
        public function isShallow(row:int, contact:ContactPoint):Boolean
        {
            return contact.depth <= ShrunkBody.SHALLOW * extentWith(bodyOf(row));
        }

        /** Whether the body goes on through a row that it touches at a place: the row is one-way, and the body does not rest on it. */
        public function passesOneWayAt(row:int, place:Vector3D):Boolean
        {
            if (!isOneWay(row))
            {
                return false;
            }
            findContact(row, place, true, _oneWayContact);
            return !isShallow(row, _oneWayContact) || passesOneWay(row, _oneWayContact);
        }
    }
}

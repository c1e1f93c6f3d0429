// This file is long because it documents all questions; it answers none itself.
package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Answers questions about agents in space: who is near, who is nearest, who touches, as a collision system sees them: as spheres of their
     * sizes, tightest fits, trees or triangles.
     *
     * <p>Agents are those of the last <code>update()</code>, where and how they were then, or at their last <code>moved()</code>; but an agent
     * that asks is where it is now, and it need not be in the list. It is never in an answer to its own question. Nothing of a Collision or of a
     * collision system changes by asking.</p>
     *
     * <p>Every list is sorted by distance, those that are equally far by their order in the list of agents, and it is complete, however long. The
     * distance of two agents is that of their places, <code>(x, y, z)</code>; a border belongs to what it encloses. With <code>out</code> given
     * nothing is allocated. An agent whose model is loading has a place, and touches nothing.</p>
     *
     * <p>An agent's breed and what a filter's <code>accepts</code> looks at are of the moment of the question.</p>
     *
     * <p>The cost of an update is a few tenths of a microsecond for each agent; the first question after it makes a tree of the places, or of the
     * extents. A question takes time in proportion to the logarithm of the number of agents, and to its answer.</p>
     */
    public class AgentQueries
    {
        private var _seen:SeenAgents;
        private var _places:PlaceQuestions;
        private var _touches:TouchQuestions;
        private var _distances:DistanceQuestions;
        private var _rays:RayQuestions;
        private var _moves:MoveQuestions;

        /**
         * Questions about no agents yet.
         *
         * @param collisionOrSystem a Collision, whose collision system says what agents look like: when it is exchanged, questions follow at the
         *     next update; or one of the engine's collision systems
         * @throws ArgumentError if it is neither, or the Collision has a system that is not one of the engine's
         */
        public function AgentQueries(collisionOrSystem:Object)
        {
            _seen = new SeenAgents(collisionOrSystem);
            _places = new PlaceQuestions(_seen);
            _touches = new TouchQuestions(_seen);
            _distances = new DistanceQuestions(_seen);
            _rays = new RayQuestions(_seen);
            _moves = new MoveQuestions(_seen);
        }

        /**
         * The ground that questions are about from the next update on; null for none. Where they were made for a Collision it is that one's, and setting it
         * changes the Collision's.
         *
         * <p>The ground touches, blocks rays and stops motions as agents do: answers have its <code>agent</code>, the last of those that are equally
         * far, and last in lists of what touches. It is never near and never nearest. A filter may leave it out.</p>
         */
        public function get terrain():Terrain
        {
            return _seen.terrain;
        }

        public function set terrain(value:Terrain):void
        {
            _seen.terrain = value;
        }

        /**
         * Takes the agents that questions are about, as they are now.
         *
         * @param agents the list; it may change afterwards, without consequence
         * @throws ArgumentError if the list or an agent is null, an agent is listed twice, or a model is unknown or lacks what the
         *     collision system needs; or if a Collision's system is not one of the engine's; questions are then about what they were before
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function update(agents:Vector.<Agent>):void
        {
            _seen.update(agents);
        }

        /**
         * Takes one agent anew, as it is now.
         *
         * @param agent one of the last update's list
         * @throws ArgumentError if it is null or not in that list, or its model is unknown or lacks what the collision system needs; it is then
         *     seen as before
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function moved(agent:Agent):void
        {
            _seen.moved(agent);
        }

        /**
         * Lists the agents that are near an agent.
         *
         * @param agent in the middle
         * @param radius the greatest distance, not negative; may be Infinity
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius is negative or not a number
         */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            var at:Placement = _seen.placeOf(agent);
            return _places.list(agent, at.x, at.y, at.z, radius, FoundRows.ALL, filter, out);
        }

        /**
         * Counts the agents that are near an agent; parameters and errors as in <code>near()</code>.
         *
         * @param agent in the middle
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            var at:Placement = _seen.placeOf(agent);
            return _places.count(agent, at.x, at.y, at.z, radius, filter);
        }

        /**
         * The agent that is nearest to an agent: the first of those that <code>near()</code> lists, found without listing them.
         *
         * @param agent to which
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         * @return null if there is none
         */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            var at:Placement = _seen.placeOf(agent);
            return _places.nearest(agent, at.x, at.y, at.z, radius, filter);
        }

        /**
         * Lists the agents that are nearest to an agent: the first of those that <code>near()</code> lists, found without listing them all.
         *
         * @param agent to which
         * @param count how many, at most
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         * @throws ArgumentError if the agent is null
         * @throws RangeError if count or radius is negative or not a number
         */
        public function nearestOf(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            if (count < 0)
            {
                throw new RangeError("count must not be negative: " + count);
            }
            var at:Placement = _seen.placeOf(agent);
            return _places.list(agent, at.x, at.y, at.z, radius, count, filter, out);
        }

        /**
         * Lists the agents that are near a point; else as <code>near()</code>.
         *
         * @param point in the world, finite
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requirePoint(point);
            return _places.list(null, point.x, point.y, point.z, radius, FoundRows.ALL, filter, out);
        }

        /**
         * Counts the agents that are near a point; else as <code>near()</code>.
         *
         * @param point in the world, finite
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            requirePoint(point);
            return _places.count(null, point.x, point.y, point.z, radius, filter);
        }

        /**
         * The agent that is nearest to a point; else as <code>nearest()</code>.
         *
         * @param point in the world, finite
         * @param radius the greatest distance
         * @param filter which agents count; null for all
         * @return null if there is none
         */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            requirePoint(point);
            return _places.nearest(null, point.x, point.y, point.z, radius, filter);
        }

        /**
         * Lists the agents in a cone in front of an agent: about the x axis of its rotation, pitch included. Agents at its very place are in
         * every cone.
         *
         * @param agent at the cone's tip
         * @param radius the greatest distance
         * @param degrees the angle of the cone's opening, half of it to either side, not negative; from 360 on the answer is that of near()
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius or the angle is negative or not a number
         */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.inCone(agent, radius, degrees, filter, out);
        }

        /**
         * Lists the agents that touch an agent: those that the collision system's findCollisions pairs it with if all stand where they are.
         *
         * @param agent which; its shape is of now too
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks what the collision system needs
         */
        public function touching(agent:Agent, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _touches.touching(agent, filter, out);
        }

        /**
         * Whether an agent touches any other: whether <code>touching()</code> would list one. It looks no further than to the first.
         *
         * @param agent which; its shape is of now too
         * @param filter which agents count; null for all. <code>accepts</code> is asked of those that it touches, the nearest first
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks what the collision system needs
         */
        public function touchesAny(agent:Agent, filter:AgentFilter = null):Boolean
        {
            return _touches.touchesAny(agent, filter);
        }

        /**
         * Whether an agent would touch any other at a place, turned and as large as it is: what <code>touchesAny()</code> would answer there. The agent
         * does not move.
         *
         * @param agent which; its shape is of now too
         * @param x where, in patches
         * @param y where
         * @param z where
         * @param filter which agents count; null for all. <code>accepts</code> is asked of those that it would touch, the nearest first
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks what the collision system needs
         * @throws RangeError if the place is not finite
         */
        public function overlapsAgent(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter = null):Boolean
        {
            if (!isFinite(x) || !isFinite(y) || !isFinite(z))
            {
                throw new RangeError("a place must be finite: (" + x + ", " + y + ", " + z + ")");
            }
            return _touches.overlapsAgent(agent, x, y, z, filter);
        }

        /**
         * Lists the agents that overlap a structure or touch it, each as the collision system sees it; in exact mode their triangles decide, and
         * whether the structure is inside of a closed model. Sorted by the distance of their places from the middle of the structure.
         *
         * @param structure a Sphere, Box or Capsule in the world
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one
         * @return out
         * @throws ArgumentError if the structure is null or of another kind
         * @throws RangeError if it is not finite
         */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _touches.overlapping(structure, filter, out);
        }

        /**
         * How far two agents are apart, between their surfaces as the collision system sees them: 0 if they touch, and only then.
         *
         * <p>A tree is the nodes at which a test of it ends; in exact mode, where both have triangles, these count. Greater depths never give less,
         * and exact mode never less than any other but the BinCollider. The first agent is where it is now, the second where and how it was in the
         * last update, or at its last <code>moved()</code>; if it is not in the list, it is where it is now too. As both are now,
         * <code>distance(b, a)</code> is the same number.</p>
         *
         * <p>Exact but for rounding: 1e-12 of the agents' sizes, and of the coordinates what Numbers leave. It takes a tenth to one microsecond
         * for structures, some ten for trees at depth 5 and hundreds in exact mode. Allocates nothing.</p>
         *
         * @param a the one
         * @param b another one
         * @param pointA takes the point of the first that is nearest to the second, in the world; or null. Of several, one. Where the two touch, a
         *     point of both: in their overlap, or on the inner one of two of which one is inside of the other
         * @param pointB takes that of the second; where the two touch, the same point
         * @return in patches; Infinity while the model of one is loading, and then no point is written
         * @throws ArgumentError if an agent is null, or both are one, or a model is unknown or lacks what the collision system needs
         */
        public function distance(a:Agent, b:Agent, pointA:Vector3D = null, pointB:Vector3D = null):Number
        {
            _distances.find(a, b, pointA, pointB);
            return _distances.closest.distance;
        }

        /**
         * How far a point is from an agent, from its surface as the collision system sees it: 0 if it is inside of the agent or touches it. In
         * exact mode it is the distance from the nearest triangle.
         *
         * @param agent which; where it is now
         * @param point in the world, finite
         * @param out takes the point of the agent that is nearest; the point itself if that is inside. Or null
         * @return in patches; Infinity while the agent's model is loading, and then out is as it was
         * @throws ArgumentError if the agent or the point is null, or the agent's model is unknown or lacks what the collision system needs
         * @throws RangeError if the point is not finite
         */
        public function distanceToPoint(agent:Agent, point:Vector3D, out:Vector3D = null):Number
        {
            requirePoint(point);
            _distances.findToPoint(agent, point, out);
            return _distances.closest.distance;
        }

        /**
         * The first agent that a ray meets, of several that it meets at one distance the first in the list. A ray is a line without thickness; the
         * surfaces of agents belong to them. An agent that the ray's origin is inside of is met at distance 0: inside of its structure, of a node
         * of its tree at the depth that is visited, or of its closed surface. Triangles are met from either side, and no ray slips through
         * where they have an edge or a corner in common.
         *
         * <p>What a system with triangles meets, the others but the BinCollider meet no farther away, and a smaller depth no farther away than a
         * greater one. The first ray that meets the extents of a model's agent, exact, prepares the model's triangles for rays, unless
         * GreatLand.prepareExact was set when the model was added: a fifth of a second for 400,000, and 38 bytes for each.</p>
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches; what is just as far away is met
         * @param filter which agents count; null for all. <code>accepts</code> is asked of those that the ray meets, the nearest first, until
         *     one is accepted
         * @param hit takes the answer; null for a new one
         * @return hit; null if the ray meets no agent, and hit is as it was
         * @throws ArgumentError if origin or direction is null or not finite, or the direction is 0
         * @throws RangeError if maxDistance is negative or not a number
         */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return _rays.cast(origin, direction, maxDistance, filter, hit);
        }

        /**
         * Lists every agent that a ray meets, where it first meets it; else as <code>cast()</code>.
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches
         * @param filter which agents count; null for all
         * @param out takes the list; null for a new one. The hits in it are written anew, and those that it has no use for are taken out, for
         *     later lists: copy what is to stay
         * @return out
         * @throws ArgumentError if origin or direction is null or not finite, or the direction is 0
         * @throws RangeError if maxDistance is negative or not a number
         */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null):Vector.<RayHit>
        {
            return _rays.castAll(origin, direction, maxDistance, filter, out);
        }

        /**
         * Whether nothing is between two agents: the line between the middles of their extents meets no other agent. Both are where they are now,
         * and need not be in the list; of an agent whose model is loading its place is the middle.
         *
         * @param a one of them
         * @param b the other
         * @param filter which agents may be in the way; null for all
         * @throws ArgumentError if one is null, or its model is unknown or lacks what the collision system needs
         */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return _rays.canSee(a, b, filter);
        }

        /**
         * The first agent that a structure touches on a straight way; of several that it touches at one time, the first in the list. Nothing moves.
         *
         * <p>What stops the structure is what would stop an agent of this shape in <code>moveUntilTouch()</code>: what it would go into, not what it
         * touches at the beginning and leaves or runs along. In exact mode the triangles of the agents decide.</p>
         *
         * @param structure a Sphere, Box or Capsule in the world, where the way begins
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all. Its <code>accepts</code> is asked of those whose extents are near the way
         * @param hit takes the answer; null for a new one
         * @return hit; null if the way is free, and hit is as it was
         * @throws ArgumentError if the structure is null or of another kind
         * @throws RangeError if the structure or the motion is not finite
         */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            AskedStructure.require(structure);
            _moves.way.setTo(dx, dy, dz);
            return _moves.cast(null, structure, filter, hit);
        }

        /**
         * Lists every agent that a structure touches on a straight way, as if the others were not there; sorted by time. Else as
         * <code>castShape()</code>.
         *
         * @param structure a Sphere, Box or Capsule in the world, where the way begins
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all
         * @param out takes the list, whose hits are written anew: copy what is to stay. Null for a new one
         * @return out
         * @throws ArgumentError as castShape does
         * @throws RangeError as castShape does
         */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            AskedStructure.require(structure);
            _moves.way.setTo(dx, dy, dz);
            return _moves.castAll(null, structure, filter, out);
        }

        /**
         * The first agent that an agent would touch on a straight way from where it is: the one that would stop it in <code>moveUntilTouch()</code>, at the
         * same time. Nothing moves.
         *
         * @param agent what is cast; it is never in the answer
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all. Its <code>accepts</code> is asked of those whose extents are near the way
         * @param hit takes the answer; null for a new one
         * @return hit; null if the way is free, or the agent's model is loading, and hit is as it was
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks what the collision system needs
         * @throws RangeError if the motion is not finite
         */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            _moves.way.setTo(dx, dy, dz);
            return _moves.cast(agent, null, filter, hit);
        }

        /**
         * Lists every agent that an agent would touch on a straight way, as if the others were not there; sorted by time. Else as
         * <code>castAgent()</code>.
         *
         * @param agent what is cast
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all
         * @param out takes the list, whose hits are written anew: copy what is to stay. Null for a new one
         * @return out
         * @throws ArgumentError as castAgent does
         * @throws RangeError as castAgent does
         */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            _moves.way.setTo(dx, dy, dz);
            return _moves.castAll(agent, null, filter, out);
        }

        /**
         * Moves an agent along a straight line until it touches another, and then as <code>moved()</code> does.
         *
         * <p>A touch that the motion leaves or runs along stops nothing, and an agent that overlaps another, as the game may have placed it, is
         * free to go where that does not deepen the overlap: not against the normal of their contact. Otherwise it stays where it is. It
         * ends in the touch, no deeper than 1e-9 of the larger extent. Others are where the last update or <code>moved()</code> saw them.</p>
         *
         * <p>The part is never greater than it would be in exact mode, but in the BinCollider, and where the agent overlaps something at the beginning.</p>
         *
         * @param agent moves; its model may be loading, and touches nothing then
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all. Its <code>accepts</code> is asked of those whose extents are near the way
         * @param contact takes how the two touch, its time being the part; only its time, 1, is set where the way is free. Or null
         * @return the part of the way that is free, from 0 to 1
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks what the collision system needs
         * @throws RangeError if the motion is not finite; the agent has not moved then
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>, of an agent that is in the list
         */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, contact:Contact = null):Number
        {
            _seen.requireMovable(agent, "moveUntilTouch");
            _moves.way.setTo(dx, dy, dz);
            return _moves.move(agent, filter, contact, false);
        }

        /**
         * Moves an agent as <code>moveUntilTouch()</code> does, and where it touches another it goes on along that: with what is left of the
         * motion, projected on the plane of the contact, or on the line in which two planes meet. All that it has touched in this motion counts, so
         * that it ends in corners. It ends half a hair from what it touches, if there is room, so that the next motion along it is free.
         *
         * @param agent moves
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param dz how far along z
         * @param filter which agents count; null for all
         * @return the length of its way, bends included, as a part of the length of the motion, from 0 to 1
         * @throws ArgumentError as moveUntilTouch does
         * @throws RangeError as moveUntilTouch does
         * @throws flash.errors.IllegalOperationError as moveUntilTouch does
         */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null):Number
        {
            _seen.requireMovable(agent, "slide");
            _moves.way.setTo(dx, dy, dz);
            return _moves.move(agent, filter, null, true);
        }

        private static function requirePoint(point:Vector3D):void
        {
            if (point == null)
            {
                throw new ArgumentError("a point is needed, not null");
            }
            if (!isFinite(point.x) || !isFinite(point.y) || !isFinite(point.z))
            {
                throw new RangeError("a point must be finite: " + point);
            }
        }
    }
}

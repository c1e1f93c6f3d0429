// This file is long because it documents all questions. It answers none itself: AgentPlaces, AgentRays and the like do.
package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.collision.QuerySource;
    import starlogo.engine;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * Answers questions about agents in space: which agents are near, which is the nearest, which touch, what a ray meets, and how far an agent
     * can go. It sees agents as a collision system does: as spheres of their sizes, tightest fits, trees or triangles.
     *
     * <p>Call <code>update()</code> once a frame. Questions see the agents of that call, as they were then. <code>refresh()</code> reads one agent
     * again. The agent that asks is always seen where it is now. It need not be in the list, and it is never in its own answer. A question
     * changes nothing in a Collision or a collision system.</p>
     *
     * <p>Every list is complete, and sorted by distance. Agents at the same distance keep the order of the list given to <code>update()</code>.
     * The distance of two agents is the distance of their places <code>(x, y, z)</code>. An agent exactly on the border of a radius or a cone is
     * in the answer. Distances have the rounding errors of Numbers: 4.4 - 1.1 is not within 3.3. An agent whose
     * model is loading has a place, but touches nothing.</p>
     *
     * <p>The agents of the ground and of the edges of the world have no place. Questions that begin at an agent's place refuse them with an
     * ArgumentError.</p>
     *
     * <p>Points and structures have to be in the world, as agents are: between -1e9 and 1e9 patches along each axis. A structure is in the world
     * if its middle is, and half of its length along each axis is at most 1e9. All else is refused with a RangeError, before anything changes.</p>
     *
     * <p>An agent's breed, and everything that a filter's <code>accepts</code> reads, is read during the question.</p>
     *
     * <p>An update takes a few tenths of a microsecond per agent. The first question after it builds a tree of the places, or of the extents.
     * The time of a question grows with the logarithm of the number of agents, and with the length of its answer. Questions skip
     * agents of breeds that do not count. The tree learns the breeds after questions have tested about as many such agents as it has, and learns
     * them anew after an agent has got another breed.</p>
     *
     * <p>A page that asks only some of the questions, and wants to load no more than these, takes SeenAgents with AgentPlaces, AgentRays or
     * AgentWalks in place of this class. Their answers are the same.</p>
     */
    public class AgentQueries
    {
        private var _seen:SeenAgents;
        private var _places:AgentPlaces;
        private var _touches:TouchQueries;
        private var _distances:DistanceQueries;
        private var _rays:AgentRays;
        private var _moves:MoveQueries;
        private var _walks:WalkQueries;

        /**
         * Begins without agents. Call <code>update()</code> before you ask: before the first one, questions that search the list throw an
         * IllegalOperationError.
         *
         * @param collisionOrSystem a Collision, or one of the engine's collision systems. The collision system decides how agents are seen. If a
         *     Collision gets another system, questions use it after the next update
         * @throws ArgumentError if it is neither, or if the Collision's system is not one of the engine's
         */
        public function AgentQueries(collisionOrSystem:Object)
        {
            var source:QuerySource = collisionOrSystem as QuerySource;
            if (source != null && !source.isForAllQuestions)
            {
                throw new ArgumentError("the shapes of a level are for AgentPlaces, AgentRays and AgentWalks: an AgentQueries needs a Collision or a collision system");
            }
            _seen = new SeenAgents(collisionOrSystem);
            // questions may be about any structure
            _seen.needTests(StructurePairTests.addTo);
            _places = new AgentPlaces(_seen);
            _touches = new TouchQueries(_seen);
            _distances = new DistanceQueries(_seen);
            _rays = new AgentRays(_seen);
            _moves = new MoveQueries(_seen);
            _walks = new WalkQueries(_seen);
        }

        /**
         * The ground that questions see after the next update; null for none. If these questions were made for a Collision, this is the
         * Collision's ground, and setting it changes the Collision.
         *
         * <p>The ground touches agents, blocks rays and stops motions as an agent does. Answers have its <code>agent</code>. If the ground
         * and an agent are equally far away, the agent comes first. In lists of agents that touch, the ground comes last. Questions about
         * near agents never find it. A filter can exclude it.</p>
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
         * Sets the agents that questions are about, and reads each of them as it is now.
         *
         * @param agents the list. You may change it afterwards; questions do not see the change
         * @throws ArgumentError if the list or an agent is null, if an agent is listed twice, if a model is unknown or lacks data that the
         *     collision system needs, or if a Collision's system is not one of the engine's. Questions are then still about the old agents
         * @throws RangeError if a structure is out of the world. Questions are then still about the old agents
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function update(agents:Vector.<Agent>):void
        {
            _seen.update(agents);
        }

        /**
         * Reads one agent again, as it is now.
         *
         * @param agent an agent of the last update's list
         * @throws ArgumentError if it is null or not in that list, or if its model is unknown or lacks data that the collision system needs.
         *     Questions then see it as before
         * @throws RangeError if its structure is out of the world. Questions then see it as before
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function refresh(agent:Agent):void
        {
            _seen.refresh(agent);
        }

        /** An older name of <code>refresh()</code>. */
        public function moved(agent:Agent):void
        {
            refresh(agent);
        }

        /**
         * Lists the agents near an agent.
         *
         * @param agent the agent in the middle
         * @param radius the largest distance in patches, not negative; may be Infinity
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius is negative or not a number
         */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.near(agent, radius, filter, out);
        }

        /**
         * Counts the agents near an agent. It throws the errors of <code>near()</code>.
         *
         * @param agent the agent in the middle
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            return _places.countNear(agent, radius, filter);
        }

        /**
         * The agent nearest to an agent: the first one in the list of <code>near()</code>. This question takes less time, because it does not
         * make the list.
         *
         * @param agent the agent that asks
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @return null if there is none
         */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _places.nearest(agent, radius, filter);
        }

        /**
         * Lists the agents nearest to an agent: the first ones in the list of <code>near()</code>. This question takes less time, because it
         * does not make the whole list.
         *
         * @param agent the agent that asks
         * @param count the largest number of agents in the list
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if count or radius is negative or not a number
         */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.nearestFew(agent, count, radius, filter, out);
        }

        /** An older name of <code>nearestFew()</code>. */
        public function nearestOf(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return nearestFew(agent, count, radius, filter, out);
        }

        /**
         * Lists the agents near a point. It works like <code>near()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.nearPoint(point, radius, filter, out);
        }

        /**
         * Counts the agents near a point. It works like <code>countNear()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            return _places.countNearPoint(point, radius, filter);
        }

        /**
         * The agent nearest to a point. It works like <code>nearest()</code>, but measures distances from the point.
         *
         * @param point in the world
         * @param radius the largest distance in patches
         * @param filter the agents that count; null for all
         * @return null if there is none
         */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _places.nearestToPoint(point, radius, filter);
        }

        /**
         * Lists the agents in a cone in front of an agent. The cone's axis is the x axis of the agent's rotation, including its pitch. Agents at
         * the same place as the agent are in every cone.
         *
         * @param agent the agent at the cone's tip
         * @param radius the largest distance in patches
         * @param degrees the full angle of the cone, not negative: half of it lies on either side of the axis. From 360 on, the answer is the
         *     same as that of near()
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null
         * @throws RangeError if the radius or the angle is negative or not a number
         */
        public function inCone(agent:Agent, radius:Number, degrees:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.inCone(agent, radius, degrees, filter, out);
        }

        /**
         * Lists the agents that touch an agent. The collision system's findCollisions would report the same pairs, for agents that stand where
         * questions see them.
         *
         * @param agent the agent that asks. Its shape is read now too
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the agent is null, or if its model is unknown or lacks data that the collision system needs
         */
        public function touching(agent:Agent, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _touches.touching(agent, filter, out);
        }

        /**
         * Whether an agent touches another: whether <code>touching()</code> would list any agent. The search ends at the first one, but with
         * <code>accepts</code> it finds all first.
         *
         * @param agent the agent that asks. Its shape is read now too
         * @param filter the agents that count; null for all. <code>accepts</code> is called for the agents that it touches, beginning with the
         *     nearest
         * @throws ArgumentError if the agent is null, or if its model is unknown or lacks data that the collision system needs
         */
        public function touchesAny(agent:Agent, filter:AgentFilter = null):Boolean
        {
            return _touches.touchesAny(agent, filter);
        }

        /**
         * Whether an agent touches an edge of the world or is beyond one. A Collision with these bounds would find the same.
         *
         * @param agent the agent that asks. Its shape is read now too
         * @param bounds the edges, as <code>collision.bounds</code> has them
         * @return false while its model is loading
         * @throws ArgumentError if one is null, or if the agent's model is unknown or lacks data that the collision system needs
         */
        public function touchesEdge(agent:Agent, bounds:WorldBounds):Boolean
        {
            return _touches.touchesEdge(agent, bounds);
        }

        /**
         * Whether an agent would touch another if it stood at a place, with its present rotation and size. <code>touchesAny()</code> would give
         * this answer there. The agent does not move.
         *
         * @param agent the agent that asks. Its shape is read now too
         * @param x the place along x, in patches
         * @param y the place along y, in patches
         * @param z the place along z, in patches
         * @param filter the agents that count; null for all. <code>accepts</code> is called for the agents that it would touch, beginning with
         *     the nearest
         * @throws ArgumentError if the agent is null, or if its model is unknown or lacks data that the collision system needs
         * @throws RangeError if the place is not in the world
         */
        public function wouldTouchAt(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter = null):Boolean
        {
            return _touches.wouldTouchAt(agent, x, y, z, filter);
        }

        /** An older name of <code>wouldTouchAt()</code>. */
        public function overlapsAgent(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter = null):Boolean
        {
            return wouldTouchAt(agent, x, y, z, filter);
        }

        /**
         * Lists the agents that overlap a structure or touch it, as the collision system sees them. In exact mode the agents' triangles decide,
         * and a structure inside a closed model overlaps it. The list is sorted by the distance of the agents' places from the middle of the
         * structure.
         *
         * @param structure a Sphere, Box, Capsule or Hull in the world
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list
         * @return out, or the new list
         * @throws ArgumentError if the structure is null or of another kind
         * @throws RangeError if it is not in the world
         */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _touches.overlapping(structure, filter, out);
        }

        /**
         * The distance between the surfaces of two agents, as the collision system sees them. It is 0 if they touch, and only then.
         *
         * <p>A tree's surface is the nodes at which a test of the tree ends. In exact mode it is the triangles, if the model has some. A
         * greater depth never gives a smaller distance. Exact mode never gives a smaller distance than another system, except the
         * BinCollider, if both models have triangles. Otherwise the leaves of both trees are their surfaces in exact mode.</p>
         *
         * <p>The first agent is seen where it is now. The second is seen as of the last update, or of its last <code>refresh()</code>. If it is
         * not in the list, it is seen where it is now. If both are seen where they are now, <code>distance(b, a)</code> is the same number.</p>
         *
         * <p>The distance is exact, except for rounding errors: 1e-12 of the agents' sizes, and the precision of Numbers at the coordinates. It
         * takes 0.1 to 1 microsecond for structures, about 10 microseconds for trees at depth 5, and hundreds of microseconds in exact mode. It
         * allocates nothing.</p>
         *
         * @param a the first agent
         * @param b the second agent
         * @param pointA receives the first agent's point that is nearest to the second, in the world; or null. If several points are equally
         *     near, it is one of them. If the two touch, it is a point of their overlap. If one agent is inside the other, it is a point of the
         *     inner one
         * @param pointB receives the second agent's nearest point; or null. If the two touch, it is the same point
         * @return in patches. While one of the models is loading, or if all edges of the world are infinite, it is Infinity and no point is written
         * @throws ArgumentError if an agent is null, if both are the same, if neither is an agent of the game but the ground or the edges, or
         *     if a model is unknown or lacks data that the collision system needs
         */
        public function distance(a:Agent, b:Agent, pointA:Vector3D = null, pointB:Vector3D = null):Number
        {
            return _distances.find(a, b, pointA, pointB);
        }

        /**
         * The distance between a point and an agent's surface, as the collision system sees the agent. It is 0 if the point is inside the agent
         * or touches it. In exact mode it is the distance to the nearest triangle.
         *
         * @param agent seen where it is now
         * @param point in the world
         * @param out receives the agent's point that is nearest to the point; or null. If the point is inside the agent, it is the point itself
         * @return in patches. While the agent's model is loading, it is Infinity and out is unchanged
         * @throws ArgumentError if the agent or the point is null, or if the agent's model is unknown or lacks data that the collision system
         *     needs
         * @throws RangeError if the point is not in the world
         */
        public function distanceToPoint(agent:Agent, point:Vector3D, out:Vector3D = null):Number
        {
            return _distances.findToPoint(agent, point, out);
        }

        /**
         * The first agent that a ray meets. If it meets several at the same distance, it is the first of them in the list. A ray is a line
         * without thickness. An agent's surface is a part of the agent.
         *
         * <p>If the ray's origin is inside an agent, the distance is 0. "Inside" means inside its structure, inside a node of its tree at the
         * depth limit, or, in exact mode, inside its closed surface. The ray meets triangles from either side. No ray slips through a common
         * edge or corner of triangles.</p>
         *
         * <p>If a ray meets an agent in exact mode, it meets the agent in every other system too, at the same distance or nearer. Only the
         * BinCollider is an exception, and models without triangles, which a ray meets at their leaves. If a ray meets an agent at one depth,
         * it meets the agent at every smaller depth too, at the same distance or nearer.</p>
         *
         * <p>In exact mode a model's triangles have to be prepared for rays. This happens when the first ray meets the extents of an agent with
         * the model, or when the model is added if GreatLand.prepareExact is set. It takes a fifth of a second for 400,000 triangles, and 38
         * bytes for each.</p>
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches. An agent at exactly this distance is met
         * @param filter the agents that count; null for all. <code>accepts</code> is called for the agents that the ray meets, beginning with
         *     the nearest, until one is accepted
         * @param hit receives the answer; null for a new RayHit
         * @return hit, or the new RayHit. It is null if the ray meets no agent, and hit is then unchanged
         * @throws ArgumentError if origin or direction is null, or if the direction is 0 or not finite
         * @throws RangeError if the origin is not in the world, or if maxDistance is negative or not a number
         */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return _rays.cast(origin, direction, maxDistance, filter, hit);
        }

        /**
         * Lists every agent that a ray meets, with the point where the ray first meets it. The rules of <code>cast()</code> apply.
         *
         * <p>With <code>allSurfaces</code> an agent has a hit for each surface that the ray crosses. The first of them is the agent's hit
         * without <code>allSurfaces</code>. All hits are sorted by distance. At the same distance they are in the order of the list, and those
         * of one agent along the ray. A ray enters a structure and leaves it. If the nodes of a tree are the surface, the ray crosses it where
         * it enters the first of nodes that overlap, and where it leaves the last. If triangles decide, each triangle is a surface. Triangles
         * that the ray meets at the same place, up to rounding, are one surface if the ray comes to them from the same side. So a common edge
         * or corner is one hit. An edge at which the ray only grazes a closed model is two: there it goes in and out. Triangles that the ray
         * runs along are one hit, where it begins to, or none if it meets another triangle there. A ray that begins inside of an agent has a
         * hit at distance 0, and one where it comes out.</p>
         *
         * @param origin where the ray begins, in the world
         * @param direction of any length but 0
         * @param maxDistance how far the ray goes, in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list. The hits in it are overwritten, and surplus hits are removed and used again later.
         *     Copy a hit that you want to keep
         * @param allSurfaces whether an agent has a hit for each surface that the ray crosses, not only for its first
         * @return out, or the new list
         * @throws ArgumentError as cast does
         * @throws RangeError as cast does
         */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            return _rays.castAll(origin, direction, maxDistance, filter, out, allSurfaces);
        }

        /**
         * Whether no agent is between two agents. It tests the line between the middles of their extents. Both agents are seen where they are
         * now, and need not be in the list. While an agent's model is loading, its place is used as its middle.
         *
         * @param a one of them
         * @param b the other
         * @param filter the agents that can be in the way; null for all
         * @throws ArgumentError if one is null, or if its model is unknown or lacks data that the collision system needs
         */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return _rays.canSee(a, b, filter);
        }

        /**
         * The first agent that a structure touches on a straight way. If it touches several at the same time, it is the first of them in the
         * list. Nothing moves.
         *
         * <p>An agent stops the structure if it would stop an agent of this shape in <code>moveUntilTouch()</code>: the structure would go
         * into it. An agent that the structure only grazes does not stop it, as when the end of a segment passes along an edge. The structure
         * may touch an agent at the beginning. That agent does not stop it if the way leaves the agent or runs along it. A frame reports all
         * of these touches. In exact mode the triangles of the agents decide.</p>
         *
         * @param structure a Sphere, Box, Capsule or Hull in the world, where the way begins
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all. Its <code>accepts</code> is called for agents whose extents are near the way
         * @param hit receives the answer; null for a new ShapeHit
         * @return hit, or the new ShapeHit. It is null if the way is free, and hit is then unchanged
         * @throws ArgumentError if the structure is null or of another kind
         * @throws RangeError if the structure is not in the world, or if a part of the motion is more than 1e9 either way or not a number
         */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castShape(structure, dx, dy, dz, filter, hit);
        }

        /**
         * Lists every agent that a structure touches on a straight way, sorted by time. Each is found as if the others were not there. The rules
         * of <code>castShape()</code> apply.
         *
         * @param structure a Sphere, Box, Capsule or Hull in the world, where the way begins
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list. The hits in it are overwritten, and surplus hits are removed and used again
         *     later. Copy a hit that you want to keep
         * @return out, or the new list
         * @throws ArgumentError as castShape does
         * @throws RangeError as castShape does
         */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castShapeAll(structure, dx, dy, dz, filter, out);
        }

        /**
         * The first agent that an agent would touch on a straight way from its present place. In <code>moveUntilTouch()</code> it would be
         * stopped by the same agent at the same time, up to rounding. <code>castShape()</code> of the agent's sphere, box, capsule or hull gives the
         * same answer, to the last bit. Nothing moves.
         *
         * @param agent the agent that is cast. It is never in the answer
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all. Its <code>accepts</code> is called for agents whose extents are near the way
         * @param hit receives the answer; null for a new ShapeHit
         * @return hit, or the new ShapeHit. It is null if the way is free or the agent's model is loading, and hit is then unchanged
         * @throws ArgumentError if the agent is null, or if its model is unknown or lacks data that the collision system needs
         * @throws RangeError if a part of the motion is more than 1e9 either way, or not a number
         */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castAgent(agent, dx, dy, dz, filter, hit);
        }

        /**
         * Lists every agent that an agent would touch on a straight way, sorted by time. Each is found as if the others were not there. The
         * rules of <code>castAgent()</code> apply.
         *
         * @param agent the agent that is cast
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all
         * @param out receives the list; null for a new list. The hits in it are overwritten, and surplus hits are removed and used again
         *     later. Copy a hit that you want to keep
         * @return out, or the new list
         * @throws ArgumentError as castAgent does
         * @throws RangeError as castAgent does
         */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castAgentAll(agent, dx, dy, dz, filter, out);
        }

        /**
         * Moves an agent along a straight line until it touches another agent. Then it calls <code>refresh()</code> for the agent.
         *
         * <p>The agent ends in the touch, no deeper than 1e-9 of the larger extent. It may touch another agent at the beginning. The other
         * agent does not stop it if the motion leaves that agent or runs along it. If the agent overlaps another at the beginning, it can
         * only move in a direction that does not make the overlap deeper: not against the normal of their contact. Otherwise it stays. The
         * other agents are seen as of the last update, or of their last <code>refresh()</code>.</p>
         *
         * <p>The free part is never greater than it would be in exact mode, except with the BinCollider, if a model has no triangles, or if the agent
         * overlaps another at the beginning.</p>
         *
         * @param agent the agent that moves. While its model is loading it touches nothing
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all. Its <code>accepts</code> is called for agents whose extents are near the way
         * @param contact receives the contact of the two, with the free part as its time; or null. If the way is free, only its time is set, to
         *     1
         * @return the free part of the way, from 0 to 1
         * @throws ArgumentError if the agent is null, or if its model is unknown or lacks data that the collision system needs
         * @throws RangeError if a part of the motion is more than 1e9 either way or not a number, or if the agent would leave the world. It has then
         *     not moved
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code> for an agent in the list
         */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, contact:Contact = null):Number
        {
            return _moves.moveUntilTouch(agent, dx, dy, dz, filter, contact);
        }

        /**
         * Moves an agent, and lets it slide along what it touches. It begins like <code>moveUntilTouch()</code>. When the agent touches another,
         * the rest of the motion is projected on the plane of the contact, or on the line where two such planes meet. All contacts of this
         * motion count, so the agent stops in a corner. If there is room, it ends a clearance (1e-10 of its extent and more) away from what it touches,
         * so that the next motion along it is free.
         *
         * @param agent the agent that moves
         * @param dx how far along x, in patches
         * @param dy how far along y, in patches
         * @param dz how far along z, in patches
         * @param filter the agents that count; null for all
         * @return the length of the agent's way, including its bends, as a part of the length of the motion, from 0 to 1
         * @throws ArgumentError as moveUntilTouch does
         * @throws RangeError as moveUntilTouch does
         * @throws flash.errors.IllegalOperationError as moveUntilTouch does
         */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null):Number
        {
            return _moves.slide(agent, dx, dy, dz, filter);
        }

        /**
         * Moves an agent along the ground, as a game character walks. The agent slides along walls. It climbs steps and slopes if they are
         * not too high and not too steep. It stays on the ground when it goes downhill or down steps.
         *
         * <p>First, if the agent that it stands on has moved or turned since the last walk, it moves and turns about the z axis with that one. Then
         * it is pushed out of what it overlaps. Neither leads through anything else. Then it goes its way.</p>
         *
         * <p>An agent that stands can climb, and it stays on the ground. An agent that does not stand goes straight on and falls, as far as
         * the options say. If something too steep stops its fall, it slides down there. On the ground plane the way is never longer than
         * <code>dx</code> and <code>dy</code>, except for a slide after a fall. Such a slide goes only down, where the way is steeper than
         * <code>slopeDegrees</code>, and at most half as far sideways as the agent may fall, or half its size. The agent ends a clearance
         * above the ground, as with <code>slide()</code>.</p>
         *
         * <p>A walk that is longer than the agent goes in pieces of the agent's size, 64 at most.</p>
         *
         * @param agent the agent that walks. While its model is loading it touches nothing
         * @param dx how far along x, in patches
         * @param dy how far along y
         * @param options how it walks; null for new WalkOptions
         * @param out receives how it stands at the end; null for a new Footing
         * @return out
         * @throws ArgumentError as moveUntilTouch does
         * @throws RangeError as moveUntilTouch does
         * @throws flash.errors.IllegalOperationError as moveUntilTouch does
         */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions = null, out:Footing = null):Footing
        {
            return _walks.walk(agent, dx, dy, options, out);
        }
    }
}

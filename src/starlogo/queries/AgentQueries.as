// The head of SeenAgents says what this room is made of; this one lists its questions. Each one is passed on, in the order of this file:
// - near to inCone: AgentPlaces finds places within a distance (NearSearch), or in a cone (Cone)
// - touching to overlapping: TouchQueries finds the rows whose bodies touch a body that stands (SweptBoxSearch, NarrowPhase)
// - distance, distanceToPoint: TouchQueries measures between two bodies (NarrowPhase)
// - cast, castAll, canSee: AgentRays finds the rows that a ray meets (SweptBoxSearch, RowRayTest)
// - castShape to slide: MoveQueries finds how far a body can go (TouchFinder, Slider)
// - walk: MoveQueries finds where a character comes to stand (WalkPlanner)
// AgentPlaces, AgentRays and AgentMotions have the same questions for games that load only these. AgentMotions has those of the last two lines.
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
     * in the answer. A radius reaches 1e-15 of its length farther, so a distance that a game has computed is a radius that reaches as far. An agent whose
     * model is loading has a place, but touches nothing.</p>
     *
     * <p>The agents of the ground and of the edges of the world have no place. Questions that begin at an agent's place refuse them with an
     * ArgumentError.</p>
     *
     * <p>Where an agent goes or stands is three numbers, as in <code>moveTo()</code>. A point that belongs to no agent, and the direction of a
     * ray, are vectors.</p>
     *
     * <p>Points and structures have to be in the world, as agents are: between -1e9 and 1e9 patches along each axis. A structure is in the world
     * if its middle is, and half of its length along each axis is at most 1e9. All else is refused with a RangeError, before anything changes.</p>
     *
     * <p>An agent's breed, and everything that a filter's <code>accepts</code> reads, is read during the question.</p>
     *
     * <p>The first question after an update builds a tree of the places, or of the extents. Times are in docs/measurements.md.
     * The time of a question grows with the logarithm of the number of agents, and with the length of its answer. Questions skip
     * agents of breeds that do not count. The tree learns the breeds after questions have tested about as many such agents as it has, and learns
     * them anew after any agent of the game has got another breed. Until then questions skip none.</p>
     *
     * <p>A page that asks only some of the questions, and wants to load no more than these, takes SeenAgents with AgentPlaces, AgentRays or
     * AgentMotions in place of this class. Their answers are the same.</p>
     */
    public class AgentQueries
    {
        private var _seen:SeenAgents;
        private var _places:AgentPlaces;
        private var _touches:TouchQueries;
        private var _rays:AgentRays;
        private var _moves:MoveQueries;

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
                throw new ArgumentError("the shapes of a level are for AgentPlaces, AgentRays and AgentMotions: an AgentQueries needs a Collision or a collision system");
            }
            _seen = new SeenAgents(collisionOrSystem);
            // questions may be about any structure
            _seen.needTests(StructurePairTests.addTo);
            _places = new AgentPlaces(_seen);
            _touches = new TouchQueries(_seen);
            _rays = new AgentRays(_seen);
            _moves = new MoveQueries(_seen);
        }

        /** @copy SeenAgents#terrain */
        public function get terrain():Terrain
        {
            return _seen.terrain;
        }

        public function set terrain(value:Terrain):void
        {
            _seen.terrain = value;
        }

        /** @copy SeenAgents#update() */
        public function update(agents:Vector.<Agent>):void
        {
            _seen.update(agents);
        }

        /** @copy SeenAgents#refresh() */
        public function refresh(agent:Agent):void
        {
            _seen.refresh(agent);
        }

        /** An older name of <code>refresh()</code>. */
        public function moved(agent:Agent):void
        {
            refresh(agent);
        }

        /** @copy AgentPlaces#near() */
        public function near(agent:Agent, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.near(agent, radius, filter, out);
        }

        /** @copy AgentPlaces#countNear() */
        public function countNear(agent:Agent, radius:Number, filter:AgentFilter = null):int
        {
            return _places.countNear(agent, radius, filter);
        }

        /** @copy AgentPlaces#nearest() */
        public function nearest(agent:Agent, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _places.nearest(agent, radius, filter);
        }

        /** @copy AgentPlaces#nearestFew() */
        public function nearestFew(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.nearestFew(agent, count, radius, filter, out);
        }

        /** An older name of <code>nearestFew()</code>. */
        public function nearestOf(agent:Agent, count:int, radius:Number = Infinity, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return nearestFew(agent, count, radius, filter, out);
        }

        /** @copy AgentPlaces#nearPoint() */
        public function nearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _places.nearPoint(point, radius, filter, out);
        }

        /** @copy AgentPlaces#countNearPoint() */
        public function countNearPoint(point:Vector3D, radius:Number, filter:AgentFilter = null):int
        {
            return _places.countNearPoint(point, radius, filter);
        }

        /** @copy AgentPlaces#nearestToPoint() */
        public function nearestToPoint(point:Vector3D, radius:Number = Infinity, filter:AgentFilter = null):Agent
        {
            return _places.nearestToPoint(point, radius, filter);
        }

        /** @copy AgentPlaces#inCone() */
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
         * allocates nothing. Times are in docs/measurements.md.</p>
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
            return _touches.distance(a, b, pointA, pointB);
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
            return _touches.distanceToPoint(agent, point, out);
        }

        /** @copy AgentRays#cast() */
        public function cast(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null, hit:RayHit = null):RayHit
        {
            return _rays.cast(origin, direction, maxDistance, filter, hit);
        }

        /** @copy AgentRays#castAll() */
        public function castAll(origin:Vector3D, direction:Vector3D, maxDistance:Number = Infinity, filter:AgentFilter = null,
                out:Vector.<RayHit> = null, allSurfaces:Boolean = false):Vector.<RayHit>
        {
            return _rays.castAll(origin, direction, maxDistance, filter, out, allSurfaces);
        }

        /** @copy AgentRays#canSee() */
        public function canSee(a:Agent, b:Agent, filter:AgentFilter = null):Boolean
        {
            return _rays.canSee(a, b, filter);
        }

        /** @copy AgentMotions#castShape() */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castShape(structure, dx, dy, dz, filter, hit);
        }

        /** @copy AgentMotions#castShapeAll() */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castShapeAll(structure, dx, dy, dz, filter, out);
        }

        /** @copy AgentMotions#castAgent() */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castAgent(agent, dx, dy, dz, filter, hit);
        }

        /** @copy AgentMotions#castAgentAll() */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castAgentAll(agent, dx, dy, dz, filter, out);
        }

        /** @copy AgentMotions#moveUntilTouch() */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, contact:Contact = null):Number
        {
            return _moves.moveUntilTouch(agent, dx, dy, dz, filter, contact);
        }

        /** @copy AgentMotions#slide() */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null):Number
        {
            return _moves.slide(agent, dx, dy, dz, filter);
        }

        /** @copy AgentMotions#walk() */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions = null, out:Footing = null):Footing
        {
            return _moves.walk(agent, dx, dy, options, out);
        }

        /** @private How far agents can go. Blocks ask more of it than games. */
        engine function get moves():MoveQueries
        {
            return _moves;
        }
    }
}

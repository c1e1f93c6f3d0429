// A walk is read in this order. WalkOptions go in, a WalkState is passed along, and a Footing comes out:
// 1. WalkPlanner.plan: carried by a platform, pushed out of overlaps, substep by substep on the ground or in the air, a fall, and a clearance at the end
// 2. MoveQueries.walk: moves the agent to where the walk ends
// 3. Slider: each way of a walk is a slide, or goes straight up or down. Both end in a MotionResult
// 4. ShrunkSweep: how such a way starts (begin), what stops it first (findStoppingImpact), and when (findTouchTime)
// 5. ShrunkBody: what stops it is what the shrunk body meets, and not what the body only touches
// moveUntilTouch and the casts: MoveQueries, TouchFinder, ShrunkSweep.findStop. Slides end a clearance before a touch, these in the touch.
// The head of MovingBody has the words of all these.
package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.pairs.TreePairTests;

    use namespace engine;

    /**
     * Moves agents, and answers how far something can go, for games that load no other questions. The rules for all
     * questions are at AgentQueries.
     */
    public final class AgentMotions
    {
        private var _moves:MoveQueries;

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentMotions(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            // A LevelShapes has no tests of pairs. A collision system has those that it needs, so an AgentQueries loads no tests of trees for a game
            // without trees. For the same reason it does not hold an AgentMotions.
            seen.needTests(StructurePairTests.addTo);
            seen.needTests(TreePairTests.addTo);
            _moves = new MoveQueries(seen);
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
         * @param out receives the list; null for a new list. The hits in it are overwritten, so none may be in it twice. Surplus hits are
         *     removed and used again later. Copy a hit that you want to keep
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
         * stopped by the same agent at the same time, up to rounding. If the agent begins deep in the ground, rounding may choose between several
         * ways out, and only one of the two questions may say that the way is free. <code>castShape()</code> of the agent's sphere, box, capsule or
         * hull gives the same answer, to the last bit. Nothing moves.
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
         * @param out receives the list; null for a new list. The hits in it are overwritten, so none may be in it twice. Surplus hits are
         *     removed and used again later. Copy a hit that you want to keep
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
         * the rest of the motion is projected on the plane of the contact, or on the line where two such planes meet. So the agent stops in a
         * corner. It turns at eight contacts at most. If there is room, it ends a clearance away from what it touches: at least 1e-10 of its
         * extent, and more near what is far larger, far from the origin, or after a motion that is far longer than the agent. So the next
         * motion along it is free.
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
         * <p>A walk that is longer than the agent goes in substeps of the agent's size, 64 at most.</p>
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
            return _moves.walk(agent, dx, dy, options, out);
        }
    }
}

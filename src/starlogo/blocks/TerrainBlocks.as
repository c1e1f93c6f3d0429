package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * The blocks for the ground and the edges of the world: "build wall", "build mound", "raise the ground", "terrain height", "reset terrain",
     * "touching ground?", "touching edge?", "edge I touch", "stop at the edge", "bounce off the edge", "wrap at the edge". The ground is
     * <code>collision.terrain</code> of the collision blocks, and the edges are <code>collision.bounds</code>. The client gives both to the game.
     * "when touching starts" with <code>Collision.EDGE</code> is the event of the edges.
     */
    public class TerrainBlocks
    {
        /** The edge of the greatest x. */
        public static const EAST:String = "east";

        /** The edge of the least x. */
        public static const WEST:String = "west";

        /** The edge of the greatest y. */
        public static const NORTH:String = "north";

        /** The edge of the least y. */
        public static const SOUTH:String = "south";

        /** The edge of the greatest z. */
        public static const TOP:String = "top";

        /** The edge of the least z. */
        public static const BOTTOM:String = "bottom";

        private static const EDGES:Array = [EAST, WEST, NORTH, SOUTH, TOP, BOTTOM];

        private static const CANNOT_BUILD:String = "cannot build here";

        private var _collisions:CollisionBlocks;
        private var _detection:DetectionBlocks;

        /**
         * Creates blocks for the ground and the edges of a game.
         *
         * @param collisions has the ground and the edges
         * @param detection finds what an agent touches
         * @throws ArgumentError if one is null
         */
        public function TerrainBlocks(collisions:CollisionBlocks, detection:DetectionBlocks)
        {
            requireGiven("collisions", collisions);
            requireGiven("detection", detection);
            _collisions = collisions;
            _detection = detection;
        }

        /** The names of the world's edges. */
        public static function get edgeNames():Array
        {
            return EDGES.concat();
        }

        /**
         * The block "build wall": raises the ground's height that is nearest to the agent.
         *
         * @param agent the agent that builds, at its place
         * @param height by how much, in patches; a negative height digs
         * @throws BlockError if something is missing, the height is not a number, or the agent is more than half a cell outside of the ground
         */
        public function buildWall(agent:Agent, height:Number):void
        {
            BlockChecks.requirePlacedAgent("build wall", agent);
            raiseAt("build wall", agent.x, agent.y, height);
        }

        /**
         * The block "build mound": raises a round hill with the agent in the middle.
         *
         * @param agent the agent that builds, at its place
         * @param width of the hill from border to border, in patches, more than 0
         * @param height of its middle, in patches; a negative height digs a hollow
         * @throws BlockError if something is missing, a number is wrong, or the hill would be wholly outside of the ground
         */
        public function buildMound(agent:Agent, width:Number, height:Number):void
        {
            BlockChecks.requirePlacedAgent("build mound", agent);
            BlockChecks.attempt("build mound", CANNOT_BUILD, groundOf("build mound").raiseMound, agent.x, agent.y, width, height);
        }

        /**
         * The block "raise the ground": raises the ground's height that is nearest to a place. It needs no agent, so a level that is built by
         * mouse is kept as such blocks.
         *
         * @param x of the place
         * @param y of the place
         * @param height by how much, in patches; a negative height digs
         * @throws BlockError if the game has no ground, a number is wrong, or the place is more than half a cell outside of the ground
         */
        public function raiseGround(x:Number, y:Number, height:Number):void
        {
            raiseAt("raise the ground", x, y, height);
        }

        /**
         * The block "terrain height": how high the ground is at the agent's place.
         *
         * @param agent the agent that asks
         * @return patches; 0 outside of the ground and over a hole
         * @throws BlockError if something is missing
         */
        public function terrainHeight(agent:Agent):Number
        {
            BlockChecks.requirePlacedAgent("terrain height", agent);
            var height:Number = groundOf("terrain height").heightAt(agent.x, agent.y);
            return isNaN(height) ? 0 : height;
        }

        /**
         * The block "reset terrain": makes the ground flat again, of height 0, without holes.
         *
         * @throws BlockError if the game has no ground
         */
        public function resetTerrain():void
        {
            groundOf("reset terrain").reset();
        }

        /**
         * The block "touching ground?": whether the agent touches the ground or is in it, as the collision system sees it. The agent's
         * present place and the ground's present heights count. If the client exchanges the ground, the new ground counts from the next
         * <code>update()</code> of the detection blocks on.
         *
         * @param agent the agent that asks
         * @return false if the game has no ground, or while the agent's model is loading
         * @throws BlockError if there is no agent
         */
        public function isTouchingGround(agent:Agent):Boolean
        {
            BlockChecks.requirePlacedAgent("touching ground?", agent);
            return _detection.isTouching(agent, Collision.TERRAIN);
        }

        /**
         * The block "touching edge?": whether the agent touches an edge of the world or is beyond it, as the collision system sees it.
         *
         * @param agent the agent that asks
         * @return false if the world has no edges, or while the agent's model is loading
         * @throws BlockError if there is no agent
         */
        public function isTouchingEdge(agent:Agent):Boolean
        {
            BlockChecks.requirePlacedAgent("touching edge?", agent);
            return _collisions.collision.bounds != null && contactWithEdge("touching edge?", agent) != null;
        }

        /**
         * The block "edge I touch": the edge of the world that the agent touches or is beyond. In a corner it is the edge that it is further
         * beyond.
         *
         * @param agent the agent that asks
         * @return one of edgeNames; null if it touches none
         * @throws BlockError if there is no agent, or the world has no edges
         */
        public function edgeTouched(agent:Agent):String
        {
            var contact:Contact = contactWithEdge("edge I touch", agent);
            if (contact == null)
            {
                return null;
            }
            // the normal points into the world
            var parts:Array = [-contact.normal.x, contact.normal.x, -contact.normal.y, contact.normal.y, -contact.normal.z, contact.normal.z];
            return EDGES[parts.indexOf(Math.max.apply(null, parts))];
        }

        /**
         * The block "stop at the edge": moves the agent back into the world, so that it only touches the edge. An agent that is wider than the world
         * has no place in it: it still reaches beyond an edge, and may be moved in every frame.
         *
         * @param agent the agent that stops
         * @throws BlockError if there is no agent, or the world has no edges
         */
        public function stopAtEdge(agent:Agent):void
        {
            CollisionBlocks.pushOut(agent, contactWithEdge("stop at the edge", agent));
        }

        /**
         * The block "bounce off the edge": moves the agent back into the world, and turns it as a mirror reflects light, if it is headed out of
         * the world. In a corner each edge is a mirror.
         *
         * @param agent the agent that bounces
         * @throws BlockError if there is no agent, or the world has no edges
         */
        public function bounceOffEdge(agent:Agent):void
        {
            var contact:Contact = contactWithEdge("bounce off the edge", agent);
            if (contact == null)
            {
                return;
            }
            CollisionBlocks.pushOut(agent, contact);
            var x:Number = Trigonometry.cosine(agent.heading);
            var y:Number = Trigonometry.sine(agent.heading);
            // the normal points into the world: from each edge that the agent touches
            var leavesAlongX:Boolean = x * contact.normal.x < 0;
            var leavesAlongY:Boolean = y * contact.normal.y < 0;
            if (leavesAlongX || leavesAlongY)
            {
                agent.heading = Trigonometry.arctangent(leavesAlongY ? -y : y, leavesAlongX ? -x : x);
            }
        }

        /**
         * The block "wrap at the edge": an agent whose place is beyond an edge comes in at the opposite edge. It has no motion in this frame.
         *
         * @param agent the agent that wraps
         * @throws BlockError if there is no agent, or the world has no edges
         */
        public function wrapAtEdge(agent:Agent):void
        {
            BlockChecks.requirePlacedAgent("wrap at the edge", agent);
            var bounds:WorldBounds = boundsOf("wrap at the edge");
            var x:Number = wrapped(agent.x, bounds.minX, bounds.maxX);
            var y:Number = wrapped(agent.y, bounds.minY, bounds.maxY);
            var z:Number = wrapped(agent.z, bounds.minZ, bounds.maxZ);
            if (x != agent.x || y != agent.y || z != agent.z)
            {
                agent.jumpTo(x, y, z);
            }
        }

        private static function wrapped(at:Number, least:Number, greatest:Number):Number
        {
            var width:Number = greatest - least;
            if (width == Infinity || width == 0 || at >= least && at <= greatest)
            {
                return at;
            }
            return least + ((at - least) % width + width) % width;
        }

        // How the agent touches the edges where it is now; null if it touches none.
        private function contactWithEdge(block:String, agent:Agent):Contact
        {
            BlockChecks.requirePlacedAgent(block, agent);
            return _collisions.contactNow(block, agent, boundsOf(block).agent);
        }

        private function raiseAt(block:String, x:Number, y:Number, height:Number):void
        {
            BlockChecks.attempt(block, CANNOT_BUILD, groundOf(block).raiseWall, x, y, height);
        }

        private function boundsOf(block:String):WorldBounds
        {
            var bounds:WorldBounds = _collisions.collision.bounds;
            if (bounds == null)
            {
                throw new BlockError(block, "needs edges of the world, but this game has none.");
            }
            return bounds;
        }

        private function groundOf(block:String):Terrain
        {
            var ground:Terrain = _collisions.collision.terrain;
            if (ground == null)
            {
                throw new BlockError(block, "needs a terrain, but this game has none.");
            }
            return ground;
        }
    }
}

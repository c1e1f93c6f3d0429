package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.queries.AgentFilter;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /**
     * The blocks for the ground and the edges of the world: "build wall", "build mound", "terrain height", "reset terrain", "touching ground?",
     * "touching edge?". The ground is <code>collision.terrain</code> of the collision blocks, and the edges are <code>collision.bounds</code>. The
     * client gives both to the game.
     */
    public class TerrainBlocks
    {
        private var _collisions:CollisionBlocks;
        private var _detection:DetectionBlocks;
        private var _ground:AgentFilter = AgentFilter.ofBreeds(Collision.TERRAIN);

        /**
         * Creates blocks for the ground and the edges of a game.
         *
         * @param collisions has the ground and the edges
         * @param detection finds what an agent touches
         * @throws ArgumentError if one is null
         */
        public function TerrainBlocks(collisions:CollisionBlocks, detection:DetectionBlocks)
        {
            if (collisions == null || detection == null)
            {
                throw new ArgumentError("collision blocks and detection blocks are needed, not " + collisions + " and " + detection);
            }
            _collisions = collisions;
            _detection = detection;
        }

        /**
         * The block "build wall": raises the ground's height that is nearest to the agent.
         *
         * @param agent the agent that builds, at its place
         * @param height by how much, in patches; a negative height digs
         * @throws BlockError if something is missing, the height is not a number, or the agent is outside of the ground
         */
        public function buildWall(agent:Agent, height:Number):void
        {
            var ground:Terrain = groundFor("build wall", agent);
            checkHeight("build wall", height);
            try
            {
                ground.raiseWall(agent.x, agent.y, height);
            }
            catch (error:RangeError)
            {
                refuse("build wall", error);
            }
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
            var ground:Terrain = groundFor("build mound", agent);
            if (!(width > 0 && width < Infinity))
            {
                throw new BlockError("build mound", "needs a width of more than 0, but got " + width + ".");
            }
            checkHeight("build mound", height);
            try
            {
                ground.raiseMound(agent.x, agent.y, width, height);
            }
            catch (error:RangeError)
            {
                refuse("build mound", error);
            }
        }

        /**
         * The block "terrain height": how high the ground is at the agent's place.
         *
         * @param agent the agent that asks
         * @return patches; 0 outside of the ground
         * @throws BlockError if something is missing
         */
        public function terrainHeight(agent:Agent):Number
        {
            var height:Number = groundFor("terrain height", agent).heightAt(agent.x, agent.y);
            return isNaN(height) ? 0 : height;
        }

        /**
         * The block "reset terrain": makes the ground flat again, of height 0.
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
            checkAgent("touching ground?", agent);
            return _detection.queries.touchesAny(agent, _ground);
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
            checkAgent("touching edge?", agent);
            var bounds:WorldBounds = _collisions.collision.bounds;
            return bounds != null && _detection.queries.touchesEdge(agent, bounds);
        }

        private function groundFor(block:String, agent:Agent):Terrain
        {
            checkAgent(block, agent);
            return groundOf(block);
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

        private static function checkAgent(block:String, agent:Agent):void
        {
            if (agent == null)
            {
                throw new BlockError(block, "needs an agent, but got nothing. Remember: \"collidee\" is an agent only while a collision block runs.");
            }
        }

        private static function checkHeight(block:String, height:Number):void
        {
            if (!isFinite(height))
            {
                throw new BlockError(block, "needs a number for the height, but got " + height + ".");
            }
        }

        private static function refuse(block:String, error:RangeError):void
        {
            throw new BlockError(block, "cannot build here: " + error.message + ".");
        }
    }
}

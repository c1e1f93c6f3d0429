package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
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
            build("build wall", agent, height, function(ground:Terrain):void
                {
                    ground.raiseWall(agent.x, agent.y, height);
                });
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
            build("build mound", agent, height, function(ground:Terrain):void
                {
                    if (!(width > 0 && width < Infinity))
                    {
                        throw new BlockError("build mound", "needs a width of more than 0, but got " + width + ".");
                    }
                    ground.raiseMound(agent.x, agent.y, width, height);
                });
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
            BlockSubject.checkAgent("terrain height", agent);
            var height:Number = groundOf("terrain height").heightAt(agent.x, agent.y);
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
            BlockSubject.checkAgent("touching ground?", agent);
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
            BlockSubject.checkAgent("touching edge?", agent);
            var bounds:WorldBounds = _collisions.collision.bounds;
            return bounds != null && _detection.queries.touchesEdge(agent, bounds);
        }

        // Calls a function that raises the ground at an agent's place.
        private function build(block:String, agent:Agent, height:Number, raise:Function):void
        {
            BlockSubject.checkAgent(block, agent);
            var ground:Terrain = groundOf(block);
            if (!isFinite(height))
            {
                throw new BlockError(block, "needs a number for the height, but got " + height + ".");
            }
            try
            {
                raise(ground);
            }
            catch (error:RangeError)
            {
                throw new BlockError(block, "cannot build here: " + error.message + ".");
            }
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

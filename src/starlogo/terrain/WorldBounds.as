package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.search.EnvironmentAgent;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.EdgePairTests;

    use namespace engine;

    /**
     * The edges of the world: the least and the greatest x, y and z. An agent touches them where its shape, as the collision system sees it, comes
     * to an edge or reaches beyond it.
     */
    public final class WorldBounds
    {
        /** @private The value of <code>agent</code>. */
        engine var environmentAgent:EnvironmentAgent = new EnvironmentAgent(Breeds.EDGE);

        /**
         * Creates the edges of the world. Where a number is infinite, the world has no edge.
         *
         * @param minX the least x, in patches; may be -Infinity
         * @param minY the least y
         * @param minZ the least z
         * @param maxX the greatest x; may be Infinity
         * @param maxY the greatest y
         * @param maxZ the greatest z
         * @throws RangeError if one is not a number, or a least one is Infinity or greater than the greatest, a greatest one is
         *     -Infinity, or a finite one is beyond Agent.LARGEST_COORDINATE
         */
        public function WorldBounds(minX:Number, minY:Number, minZ:Number, maxX:Number, maxY:Number, maxZ:Number)
        {
            setTo(minX, minY, minZ, maxX, maxY, maxZ);
        }

        /**
         * Moves the edges. The parameters and the errors are the same as in the constructor. After an error the edges are where they were.
         *
         * @param minX the least x; may be infinite
         * @param minY the least y; may be infinite
         * @param minZ the least z; may be infinite
         * @param maxX the greatest x; may be infinite
         * @param maxY the greatest y; may be infinite
         * @param maxZ the greatest z; may be infinite
         * @throws RangeError as the constructor does
         */
        public function setTo(minX:Number, minY:Number, minZ:Number, maxX:Number, maxY:Number, maxZ:Number):void
        {
            var edges:Vector.<Number> = new <Number>[minX, maxX, minY, maxY, minZ, maxZ];
            for (var i:int = 0; i < 6; i += 2)
            {
                if (!(edges[i] <= edges[i + 1] && edges[i] < Infinity && edges[i + 1] > -Infinity))
                {
                    var rule:String = isNaN(edges[i] + edges[i + 1]) ? " of the world must be numbers, not " : " of the world must have a place between them, not ";
                    throw new RangeError("the least and the greatest " + "xyz".charAt(i / 2) + rule + edges[i] + " and " + edges[i + 1]);
                }
                requireInWorld("the edges of the world", isFinite(edges[i]) ? edges[i] : 0, isFinite(edges[i + 1]) ? edges[i + 1] : 0, 0);
            }
            environmentAgent.revision++;
            environmentAgent.surface = ModelShape.ofEnvironment(null, edges, EdgePairTests.addTo);
        }

        /** The least x. */
        public function get minX():Number
        {
            return environmentAgent.surface.edges[0];
        }

        /** The greatest x. */
        public function get maxX():Number
        {
            return environmentAgent.surface.edges[1];
        }

        /** The least y. */
        public function get minY():Number
        {
            return environmentAgent.surface.edges[2];
        }

        /** The greatest y. */
        public function get maxY():Number
        {
            return environmentAgent.surface.edges[3];
        }

        /** The least z. */
        public function get minZ():Number
        {
            return environmentAgent.surface.edges[4];
        }

        /** The greatest z. */
        public function get maxZ():Number
        {
            return environmentAgent.surface.edges[5];
        }

        /**
         * The agent that stands for the edges in handlers. Its breed is <code>Collision.EDGE</code>, and it is in no list. Its other traits do
         * not count.
         */
        public function get agent():Agent
        {
            return environmentAgent;
        }
    }
}

package starlogo.blocks
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.collision.Contact;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.copyVector;

    use namespace engine;

    /**
     * The blocks that tell how two agents touch: "side that was hit", "touch point", "touch speed", "push away from". In a collision block they
     * are about the touch of this frame.
     */
    public class ContactBlocks
    {
        /** The side towards which the agent is headed. */
        public static const FRONT:String = "front";

        /** The side against the heading. */
        public static const BACK:String = "back";

        /** The side on the left of the heading. */
        public static const LEFT:String = "left";

        /** The side on the right of the heading. */
        public static const RIGHT:String = "right";

        /** The upper side. */
        public static const TOP:String = "top";

        /** The lower side. */
        public static const BOTTOM:String = "bottom";

        private static const SIDES:Array = [FRONT, BACK, LEFT, RIGHT, TOP, BOTTOM];

        private static const UNKNOWN_SHAPE:String = "does not know the shape of an agent yet";

        private var _collisions:CollisionBlocks;

        /**
         * Creates blocks for the contacts of a game.
         *
         * @param collisions has the collision system in use
         * @throws ArgumentError if it is null
         */
        public function ContactBlocks(collisions:CollisionBlocks)
        {
            requireGiven("collisions", collisions);
            _collisions = collisions;
        }

        /** The sides of an agent. */
        public static function get sideNames():Array
        {
            return SIDES.concat();
        }

        /**
         * The block "side that was hit": the side of the agent that the other one touches. The contact's normal decides.
         *
         * @param agent the agent whose side it is
         * @param other the agent that touches it
         * @return one of sideNames. Of two sides that are equally near, the first in this list
         * @throws BlockError if one is missing, both are the same, one is the ground's agent and the other the edges', or the model of one is
         *     unknown or still loading
         */
        public function sideHit(agent:Agent, other:Agent):String
        {
            var normal:Vector3D = contactOf("side that was hit", agent, other).normal;
            // the normal points away from the other agent
            var cos:Number = Trigonometry.cosine(agent.heading);
            var sin:Number = Trigonometry.sine(agent.heading);
            var front:Number = -normal.x * cos - normal.y * sin;
            var left:Number = normal.x * sin - normal.y * cos;
            var parts:Array = [front, -front, left, -left, -normal.z, normal.z];
            var most:int = 0;
            for (var i:int = 1; i < 6; i++)
            {
                // a rounding does not decide between two sides
                if (parts[i] > parts[most] + 1e-9)
                {
                    most = i;
                }
            }
            return SIDES[most];
        }

        /**
         * The block "touch point": where two agents touch.
         *
         * @param agent one of them
         * @param other the other
         * @param out receives the point; null for a new one
         * @return out, or the new point
         * @throws BlockError if one is missing, both are the same, one is the ground's agent and the other the edges', or the model of one is
         *     unknown or still loading
         */
        public function touchPoint(agent:Agent, other:Agent, out:Vector3D = null):Vector3D
        {
            out ||= new Vector3D();
            copyVector(contactOf("touch point", agent, other).point, out);
            return out;
        }

        /**
         * The block "touch speed": how fast two agents came together, in patches a frame.
         *
         * @param agent one of them
         * @param other the other
         * @return 0 if neither collides along its way (<code>sweeps</code>), or if they part
         * @throws BlockError if one is missing, both are the same, one is the ground's agent and the other the edges', or the model of one is
         *     unknown or still loading
         */
        public function touchSpeed(agent:Agent, other:Agent):Number
        {
            return contactOf("touch speed", agent, other).approachSpeed;
        }

        /**
         * The block "push away from": moves the agent out of the other one by the shortest way. Both count at their present places. It moves
         * through whatever is there.
         *
         * @param agent the agent that moves
         * @param other the agent that stays. If the two do not touch, nothing moves
         * @throws BlockError if one is missing, if both are the same, if the one that moves is the ground's agent or the edges', if the model of one
         *     is unknown, or if the game has given its Collision a collision system of its own
         * @throws RangeError if the agent would leave the world; it then stays
         */
        public function pushAway(agent:Agent, other:Agent):void
        {
            BlockChecks.requirePair("push away from", agent, other);
            BlockChecks.requirePlacedAgent("push away from", agent);
            // in JavaScript a method of the engine's namespace can't be passed itself
            var contact:Object = BlockChecks.attempt("push away from", UNKNOWN_SHAPE, function():Contact
                {
                    return _collisions.contactNow("push away from", agent, other);
                });
            CollisionBlocks.pushOut(agent, contact as Contact);
        }

        private function contactOf(block:String, agent:Agent, other:Agent):Contact
        {
            BlockChecks.requirePair(block, agent, other);
            // a game's own system may return null
            var contact:Contact = new Contact();
            return (BlockChecks.attempt(block, UNKNOWN_SHAPE, _collisions.collision.systemOfFrame.contactOf, agent, other, contact) || contact) as Contact;
        }
    }
}

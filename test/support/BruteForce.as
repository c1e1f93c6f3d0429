package support
{
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;

    /** Collisions by trying every pair: what the colliders must agree with. */
    public final class BruteForce
    {
        /** Every pair of agents whose unit spheres, scaled and moved (thesis §2.2), meet: a0, b0, a1, b1, ... */
        public static function spheres(agents:Vector.<Agent>):Vector.<Agent>
        {
            var pairs:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < agents.length; i++)
            {
                var a:Agent = agents[i];
                var x:Number = a.x;
                var y:Number = a.y;
                var size:Number = a.size;
                var z:Number = a.z + size / 2;
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    var b:Agent = agents[j];
                    var reach:Number = (size + b.size) / 2;
                    var dx:Number = x - b.x;
                    var dy:Number = y - b.y;
                    var dz:Number = z - (b.z + b.size / 2);
                    if (dx * dx + dy * dy + dz * dz <= reach * reach)
                    {
                        pairs.push(a, b);
                    }
                }
            }
            return pairs;
        }

        /** Every pair of agents that a system calls colliding, asked one pair at a time. */
        public static function ask(system:CollisionSystem, agents:Vector.<Agent>):Vector.<Agent>
        {
            var pairs:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    if (system.areColliding(agents[i], agents[j]))
                    {
                        pairs.push(agents[i], agents[j]);
                    }
                }
            }
            return pairs;
        }

        /**
         * What two lists of pairs differ in, in words; "" if they have the same pairs, each once, with the agents of each
         * pair in the same order.
         */
        public static function difference(expected:Vector.<Agent>, found:Vector.<Agent>):String
        {
            var seen:Object = {};
            for (var i:int = 0; i < expected.length; i += 2)
            {
                seen[expected[i].id + " " + expected[i + 1].id] = 1;
            }
            for (i = 0; i < found.length; i += 2)
            {
                var key:String = found[i].id + " " + found[i + 1].id;
                if (!seen.hasOwnProperty(key))
                {
                    return "not a collision: " + describe(found[i], found[i + 1]);
                }
                if (seen[key] == 2)
                {
                    return "found twice: " + describe(found[i], found[i + 1]);
                }
                seen[key] = 2;
            }
            for (i = 0; i < expected.length; i += 2)
            {
                if (seen[expected[i].id + " " + expected[i + 1].id] == 1)
                {
                    return "missed: " + describe(expected[i], expected[i + 1]);
                }
            }
            return "";
        }

        private static function describe(a:Agent, b:Agent):String
        {
            return place(a) + " and " + place(b);
        }

        private static function place(agent:Agent):String
        {
            return agent + " at (" + agent.x + ", " + agent.y + ", " + agent.z + ") of size " + agent.size;
        }
    }
}

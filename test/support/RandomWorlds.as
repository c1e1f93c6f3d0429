package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;

    /** Seeded random worlds of agents, of kinds that are hard on bins each in its own way. */
    public final class RandomWorlds
    {
        /** The kinds that <code>fill</code> knows. */
        public static const KINDS:Array = ["scattered", "mixed sizes", "far out", "clusters", "on borders", "one place", "in a row", "wide and sparse"];

        /**
         * Makes a world.
         *
         * @param kind one of KINDS
         * @param count how many agents
         * @param shape their shape
         */
        public static function make(kind:String, count:int, shape:String, random:SeededRandom):Vector.<Agent>
        {
            var place:Function = placers()[kind];
            var world:Object = {x: random.between(-1e6, 1e6), y: random.between(-1e6, 1e6), spread: random.logBetween(1, 100), count: count};
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(shape);
                place(agent, world, random);
                agents.push(agent);
            }
            return agents;
        }

        /**
         * Makes agents of several shapes about the origin: upright or not, with their structures or their trees.
         *
         * @param reach how far away they are along each axis, at most
         */
        public static function mixed(count:int, shapes:Array, reach:Number, random:SeededRandom):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = agentAt(random.pick(shapes), random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach));
                agent.heading = random.pick([0, 90, random.between(0, 360)]);
                agent.size = random.logBetween(0.3, 4);
                agent.hierarchical = random.chance();
                if (random.chance())
                {
                    agent.pitch = random.between(-90, 90);
                    agent.roll = random.between(-90, 90);
                }
                agents.push(agent);
            }
            return agents;
        }

        private static function placers():Object
        {
            return {
                    "scattered": scattered,
                    "mixed sizes": mixedSizes,
                    "far out": farOut,
                    "clusters": clusters,
                    "on borders": onBorders,
                    "one place": onePlace,
                    "in a row": inARow,
                    "wide and sparse": wideAndSparse
                };
        }

        private static function scattered(agent:Agent, world:Object, random:SeededRandom):void
        {
            // as dense as a hundred agents on 10 by 10 patches, more or less
            var half:Number = Math.sqrt(world.count) * 0.7;
            agent.moveTo(random.between(-half, half), random.between(-half, half), random.between(0, 1));
        }

        private static function mixedSizes(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(random.between(-50, 50), random.between(-50, 50), random.between(-10, 10));
            agent.size = random.logBetween(0.01, 50);
        }

        private static function farOut(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(world.x + random.normal() * world.spread, world.y + random.normal() * world.spread, random.normal());
            agent.size = random.logBetween(0.5, 4);
        }

        private static function clusters(agent:Agent, world:Object, random:SeededRandom):void
        {
            var cluster:int = random.integer(0, 3);
            agent.moveTo(cluster * 3000 + random.normal() * 2, cluster * cluster * -700 + random.normal() * 2, random.normal());
            agent.size = random.logBetween(0.1, 2);
        }

        // Whole and half patches and sizes that are powers of two: rectangles end on borders, spheres touch exactly.
        private static function onBorders(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(random.integer(-12, 12) / 2, random.integer(-12, 12) / 2, random.integer(0, 2) / 2);
            agent.size = Math.pow(2, random.integer(-2, 1));
        }

        private static function onePlace(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(world.x, world.y, random.between(0, world.count));
        }

        private static function inARow(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(random.between(-world.count / 2, world.count / 2), 0, 0);
            agent.size = random.logBetween(0.5, 2);
        }

        private static function wideAndSparse(agent:Agent, world:Object, random:SeededRandom):void
        {
            agent.moveTo(random.between(-1e6, 1e6), random.between(-1e6, 1e6), random.between(-1e3, 1e3));
            agent.size = random.chance(0.1) ? random.logBetween(1e4, 1e6) : random.logBetween(0.01, 50);
        }
    }
}

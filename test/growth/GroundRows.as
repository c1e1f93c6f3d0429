package growth
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.collision.TightestFitCollider;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;
    import support.agentAt;

    /** The ground: n is the number of cells, or the number of agents on ground of as many cells. */
    public final class GroundRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [
                    new GrowthRow("ground: heights set", "cells", 400, 1000000, beginHeights),
                    new GrowthRow("ground: heights set, a question after each", "cells", 400, 100000, beginAsked),
                    new GrowthRow("ground: mounds and walls", "cells", 400, 1000000, beginMounds),
                    new GrowthRow("ground: a frame", "agents", 100, 200000, beginFrame(0.9, 1)),
                    new GrowthRow("ground: contacts in flat ground", "agents", 100, 200000, beginFrame(0.9, 0)),
                    new GrowthRow("ground: a sphere over many cells", "cells", 400, 1000000, beginWide("ball", false)),
                    new GrowthRow("ground: a box over many cells", "cells", 400, 1000000, beginWide("cube", false)),
                    new GrowthRow("ground: a box over many columns", "cells", 400, 1000000, beginWide("cube", true)),
                    new GrowthRow("ground: a walk over many cells", "cells", 400, 100000, beginLongWalk),
                    new GrowthRow("ground: a wide agent walks", "cells", 400, 100000, beginWideWalk),
                    new GrowthRow("ground: distances from far above", "cells", 400, 1000000, beginFar),
                    new GrowthRow("ground: distances over holes", "cells", 400, 1000000, beginOverHoles),
                    new GrowthRow("ground: rays along it", "cells", 400, 1000000, beginRays),
                    new GrowthRow("ground: walks", "agents", 25, 40000, beginWalks),
                    new GrowthRow("ground: snapshots", "cells", 400, 200000, beginSnapshots)];
        }

        private static function beginHeights(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var terrain:Terrain = rough(n, 1);
                for (var i:int = 0; i < n; i++)
                {
                    terrain.setHeight(i % terrain.columns, int(i / terrain.columns) % terrain.rows, i % 3);
                }
                return terrain;
            };
        }

        // A game that digs, and asks where agents stand after each change.
        private static function beginAsked(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = rough(n, 1);
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(GrowthGame.land()));
            var agent:Agent = agentAt("ball", 5, 5, 3);
            queries.terrain = terrain;
            queries.update(new <Agent>[agent]);
            return function():Object
            {
                var sum:Number = 0;
                for (var i:int = 0; i < n; i++)
                {
                    terrain.setHeight(i % terrain.columns, int(i / terrain.columns) % terrain.rows, i % 3);
                    sum += queries.distance(agent, terrain.agent);
                }
                return sum;
            };
        }

        private static function beginMounds(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var terrain:Terrain = rough(n, 1);
                for (var i:int = 0; i < 10; i++)
                {
                    terrain.raiseMound(i, i, terrain.columns, 1);
                    terrain.raiseWall(i, i, 3);
                }
                return terrain;
            };
        }

        // Agents in the ground, and a handler that takes contacts.
        private static function beginFrame(z:Number, height:Number):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5, z - 1);
                var collision:Collision = collisionOn(rough(4 * n, height));
                collision.onCollision(Collision.TERRAIN, "turtles", keep);
                return function():Object
                {
                    for each (var agent:Agent in agents)
                    {
                        agent.moveTo(agent.x + 0.001, agent.y, agent.z);
                    }
                    collision.update(agents);
                    return collision;
                };
            };
        }

        private static function beginWide(shape:String, isBlocky:Boolean):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var terrain:Terrain = rough(n, 1);
                terrain.isBlocky = isBlocky;
                var agents:Vector.<Agent> = new <Agent>[wideOn(terrain, shape)];
                var collision:Collision = collisionOn(terrain);
                collision.onCollision(Collision.TERRAIN, "turtles", keep);
                return function():Object
                {
                    var queries:AgentQueries = new AgentQueries(collision);
                    agents[0].moveTo(agents[0].x, agents[0].y + 0.001, agents[0].z);
                    collision.update(agents);
                    queries.update(agents);
                    return [queries.touchesAny(agents[0]), queries.distance(agents[0], terrain.agent)];
                };
            };
        }

        private static function beginLongWalk(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = new Terrain(n / 2, 3);
            return walking(terrain, agentAt("ball", 1, 1, 0), n / 2 - 4);
        }

        private static function beginWideWalk(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = rough(n, 1);
            return walking(terrain, wideOn(terrain, "ball"), 1);
        }

        private static function beginFar(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = rough(n, 1);
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(GrowthGame.land()));
            queries.terrain = terrain;
            return function():Object
            {
                var sum:Number = 0;
                for (var z:Number = 1; z < 1e9; z *= 10)
                {
                    sum += queries.distanceToPoint(terrain.agent, new Vector3D(0, 0, z));
                    sum += queries.distance(agentAt("cube", 3, 4, z), terrain.agent);
                }
                return sum;
            };
        }

        // All of the ground is holes but its last cells. A question may take no longer on more ground.
        private static function beginOverHoles(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = rough(n, 1);
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(GrowthGame.land()));
            row.exponent = GrowthRow.CONSTANT;
            queries.terrain = terrain;
            for (var i:int = 0; i < terrain.columns * (terrain.rows - 2); i++)
            {
                terrain.setHole(i % terrain.columns, i / terrain.columns, true);
            }
            return function():Object
            {
                var sum:Number = 0;
                for (var x:int = 0; x < 100; x++)
                {
                    sum += queries.distance(agentAt("ball", 0.01 * x * terrain.columns, 1, 1), terrain.agent);
                }
                return sum;
            };
        }

        private static function beginRays(n:int, row:GrowthRow):Function
        {
            var terrain:Terrain = rough(n, 1);
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(GrowthGame.land()));
            terrain.setHeight(0, terrain.rows - 1, 9);
            queries.terrain = terrain;
            queries.update(new <Agent>[]);
            return function():Object
            {
                var found:int = 0;
                for (var i:int = 0; i < terrain.rows; i++)
                {
                    found += queries.cast(new Vector3D(-1, i, 1.01), new Vector3D(1, 0.1, 0)) == null ? 0 : 1;
                }
                return found;
            };
        }

        private static function beginWalks(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5, 1);
            var collision:Collision = collisionOn(rough(4 * n, 0.3));
            var queries:AgentQueries = new AgentQueries(collision);
            collision.update(agents);
            queries.update(agents);
            return function():Object
            {
                for each (var agent:Agent in agents)
                {
                    queries.walk(agent, 0.1, 0.05);
                    queries.moved(agent);
                }
                return queries;
            };
        }

        private static function beginSnapshots(n:int, row:GrowthRow):Function
        {
            var collision:Collision = collisionOn(rough(n, 1));
            var agents:Vector.<Agent> = GrowthGame.square(n / 100, "ball", 1.5, 1);
            collision.update(agents);
            return function():Object
            {
                collision.restore(collision.snapshot(), agents);
                return collision;
            };
        }

        // There and back.
        private static function walking(terrain:Terrain, agent:Agent, dx:Number):Function
        {
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(GrowthGame.land()));
            queries.terrain = terrain;
            queries.update(new <Agent>[agent]);
            return function():Object
            {
                queries.walk(agent, dx, 0);
                return queries.walk(agent, -dx, 0);
            };
        }

        private static function collisionOn(terrain:Terrain):Collision
        {
            var collision:Collision = new Collision(new TightestFitCollider(GrowthGame.land()));
            collision.terrain = terrain;
            return collision;
        }

        // An agent that is nearly as wide as the ground, and a little in it.
        private static function wideOn(terrain:Terrain, shape:String):Agent
        {
            var agent:Agent = agentAt(shape, terrain.columns / 2, terrain.rows / 2, 0.9);
            agent.size = 0.8 * Math.min(terrain.columns, terrain.rows);
            return agent;
        }

        // Ground of n cells in a square. Each height is another than its neighbours'.
        private static function rough(n:int, height:Number):Terrain
        {
            var side:int = Math.max(4, Math.sqrt(n));
            var terrain:Terrain = new Terrain(side, side);
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < side * side; i++)
            {
                heights.push(height * ((7 * i + int(i / side)) % 5) / 4);
            }
            terrain.setHeights(0, 0, side, side, heights);
            return terrain;
        }

        private static function keep(ground:Agent, agent:Agent, contact:Contact):void
        {
            agent.color = contact.depth;
        }
    }
}

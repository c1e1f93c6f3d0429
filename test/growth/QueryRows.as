package growth
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;

    /** Questions: n agents, each of which asks one. */
    public final class QueryRows
    {
        private static const FOUND:Vector.<Agent> = new Vector.<Agent>();
        private static const HIT:RayHit = new RayHit();

        /** All rows. */
        public static function get all():Array
        {
            return [
                    ofEach("near", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.near(agent, 3, null, FOUND);
                        }),
                    ofEach("countNear, far", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.countNear(agent, 1e6);
                        }),
                    ofEach("nearest", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.nearest(agent);
                        }),
                    ofEach("nearestFew 8", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.nearestFew(agent, 8, Infinity, null, FOUND);
                        }),
                    ofEach("inCone", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.inCone(agent, 4, 60, null, FOUND);
                        }),
                    ofEach("touching", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.touching(agent, null, FOUND);
                        }),
                    ofEach("touching, of trees and triangles", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.touching(agent, null, FOUND);
                        }, true),
                    ofEach("overlapping", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.overlapping(new Sphere(new Vector3D(agent.x, agent.y, 0), 2), null, FOUND);
                        }),
                    ofEach("wouldTouchAt", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.wouldTouchAt(agent, agent.x + 0.3, agent.y, 0);
                        }),
                    ofEach("cast", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.cast(new Vector3D(agent.x - 0.8, agent.y - 0.8, 0.5), new Vector3D(1, 2, 0), 20, null, HIT);
                        }),
                    ofEach("canSee", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.canSee(agent, queries.nearestToPoint(new Vector3D(agent.x + 8, agent.y + 3, 0)));
                        }),
                    ofEach("castAgent", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.castAgent(agent, 3, 2, 0);
                        }),
                    ofEach("moveUntilTouch, then refresh", function(queries:AgentQueries, agent:Agent):Object
                        {
                            queries.moveUntilTouch(agent, 0.2, 0.1, 0);
                            queries.refresh(agent);
                            return agent;
                        }),
                    ofEach("slide, then refresh", function(queries:AgentQueries, agent:Agent):Object
                        {
                            queries.slide(agent, 0.4, 0.1, 0);
                            queries.refresh(agent);
                            return agent;
                        }),
                    ofEach("refresh, then nearest", function(queries:AgentQueries, agent:Agent):Object
                        {
                            agent.moveTo(agent.x + 0.7, agent.y + 0.2, 0);
                            queries.refresh(agent);
                            return queries.nearest(agent);
                        }),
                    new GrowthRow("ask: a ray past all of them", "agents", 100, 1000000, beginLongRays),
                    new GrowthRow("ask: nearest of agents in one place", "agents", 100, 1000000, beginHeap),
                    new GrowthRow("ask: nearest, sizes over many orders", "agents", 100, 200000, beginSizes)];
        }

        // Agents in a square; every fourth touches the next.
        private static function ofEach(name:String, ask:Function, areTrees:Boolean = false):GrowthRow
        {
            return new GrowthRow("ask: " + name, "agents", 50, 200000, function(n:int, row:GrowthRow):Function
                {
                    var agents:Vector.<Agent> = GrowthGame.square(n, areTrees ? "cube" : "ball", 1.5);
                    for (var i:int = 0; i < n; i += 4)
                    {
                        agents[i].moveTo(agents[i].x + 0.7, agents[i].y, 0);
                        agents[i].hierarchical = areTrees;
                    }
                    var collider:CombinationCollider = new CombinationCollider(GrowthGame.land(areTrees));
                    collider.exact = areTrees;
                    return asking(collider, agents, ask);
                });
        }

        private static function asking(system:CollisionSystem, agents:Vector.<Agent>, ask:Function):Function
        {
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for each (var agent:Agent in agents)
                {
                    ask(queries, agent);
                }
                return queries;
            };
        }

        private static function beginLongRays(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            var system:CollisionSystem = new TightestFitCollider(GrowthGame.land());
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for (var i:int = 0; i < Math.sqrt(n); i++)
                {
                    queries.cast(new Vector3D(-5, 1.5 * i + 0.75, 0.5), new Vector3D(1, 0, 0), Infinity, null, HIT);
                }
                return queries;
            };
        }

        private static function beginHeap(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 0);
            var system:CollisionSystem = new BinCollider(GrowthGame.land());
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for (var i:int = 0; i < 10; i++)
                {
                    queries.nearest(agents[i]);
                }
                return queries;
            };
        }

        private static function beginSizes(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            for (var i:int = 0; i < n; i++)
            {
                agents[i].size = Math.pow(10, i % 6 - 5);
            }
            return asking(new TightestFitCollider(GrowthGame.land()), agents, function(queries:AgentQueries, agent:Agent):Object
                {
                    return queries.nearest(agent) && queries.touchesAny(agent);
                });
        }
    }
}

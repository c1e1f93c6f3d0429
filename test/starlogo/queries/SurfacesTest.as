package starlogo.queries
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.Effort;
    import support.EveryTriangle;
    import support.RandomWorlds;
    import support.SolidModels;

    use namespace engine;

    /** All surfaces that a ray crosses: castAll with allSurfaces, against loops over all triangles, nodes and structures. */
    public class SurfacesTest
    {
        private static var sModels:Object;
        private static var sShapes:Array;
        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(4711);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _agents:Vector.<Agent>;
        private var _origin:Vector3D;
        private var _direction:Vector3D;
        private var _isUnclear:Boolean;

        [BeforeClass]
        public static function load():void
        {
            sModels = {};
            sShapes = [];
            sGreatLand = new GreatLand();
            sGreatLand.orientedBoxDegIncrement = 45;
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder(), BuiltInModel.sphere(), sheet("sheet")))
            {
                addModel(model);
                sShapes.push(model.name);
            }
        }

        // Random agents have this shape only if load() lists it, so a test does not depend on which others ran before it.
        private static function addModel(model:Model):void
        {
            sModels[model.name] = model;
            sGreatLand.addModel(model);
        }

        // Two triangles at z = 0, with a common edge along x = y.
        private static function sheet(name:String):Model
        {
            return new Model(name, new <Number>[-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0], new <uint>[0, 1, 2, 0, 2, 3]);
        }

        [Test(timeout="3600000")]
        public function trianglesAreCrossedAsALoopFinds():void
        {
            compare("triangles", Effort.choose(24, 400), trianglesOf);
        }

        [Test(timeout="3600000")]
        public function nodesAreCrossedAsALoopFinds():void
        {
            compare("hierarchies", Effort.choose(24, 400), nodesOf);
        }

        /** In exact mode the smallest nodes of a model without triangles decide. */
        [Test]
        public function smallestNodesAreCrossedIfThereAreNoTriangles():void
        {
            var land:GreatLand = new GreatLand();
            land.addModel(new Model("points", BuiltInModel.sphere().vertices));
            var agents:Vector.<Agent> = new <Agent>[new Agent("points")];
            var told:Array = ["", "", ""];
            for (var i:int = 0; i < 3; i++)
            {
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = i == 0;
                collider.maxDepth = i == 1 ? int.MAX_VALUE : 2;
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(agents);
                for (var k:int = 0; k < 20; k++)
                {
                    for each (var hit:RayHit in queries.castAll(new Vector3D(0.02 * k, -3, 0.5), new Vector3D(0, 1, 0), Infinity, null, null, true))
                    {
                        told[i] += hit.distance + " ";
                    }
                }
            }
            assertEquals(told[1], told[0]);
            assertFalse("larger nodes are crossed elsewhere", told[2] == told[0]);
        }

        [Test(timeout="3600000")]
        public function structuresAreEnteredAndLeft():void
        {
            compare("bins", Effort.choose(24, 400), function(agent:Agent):Array
                {
                    return ofSphere(new Vector3D(agent.x, agent.y, agent.z + 0.5 * agent.size), 0.5 * agent.size);
                });
        }

        [Test]
        public function theFirstSurfaceIsTheHitInEverySystem():void
        {
            for each (var system:String in EachCollider.NAMES)
            {
                compare(system, 16, null);
            }
        }

        // A loop finds the distances of an agent's surfaces, in any order, and says if they are not clear.
        private function compare(system:String, worlds:int, loop:Function):void
        {
            var counts:Object = {hits: 0, agents: 0, unclear: 0, all: 0};
            for (var world:int = 0; world < worlds; world++)
            {
                makeWorld(RandomWorlds.KINDS[world % RandomWorlds.KINDS.length], 12);
                var queries:AgentQueries = queriesOf(system);
                for (var i:int = 0; i < 25; i++)
                {
                    choose();
                    var most:Number = _random.pick([Infinity, Infinity, _random.between(0, 60)]);
                    var message:String = system + ", world " + world + ", ray " + i + ", from " + _origin + " along " + _direction + " up to " + most;
                    var hits:Vector.<RayHit> = queries.castAll(_origin, _direction, most, null, null, true);
                    checkFirsts(message, hits, queries.castAll(_origin, _direction, most));
                    counts.hits += hits.length;
                    for (var k:int = 0; loop != null && k < _agents.length; k++)
                    {
                        compareAgent(message, _agents[k], hits, most, loop, counts);
                    }
                }
            }
            assertTrue(system + ": hits " + counts.hits, counts.hits > 20 * worlds);
            assertTrue("agents " + counts.agents + ", unclear " + counts.unclear + " of " + counts.all, loop == null || counts.agents > 5 * worlds && counts.unclear < 0.6 * counts.all);
        }

        private function compareAgent(message:String, agent:Agent, hits:Vector.<RayHit>, most:Number, loop:Function, counts:Object):void
        {
            _isUnclear = false;
            var slack:Number = 1e-7 * agent.size + 1e-9 * Math.min(1e9, _origin.length + Math.abs(agent.x) + Math.abs(agent.y));
            var expected:Array = loop(agent).sort(Array.NUMERIC);
            var found:Array = [];
            for each (var hit:RayHit in hits)
            {
                if (hit.agent == agent)
                {
                    found.push(hit.distance);
                }
            }
            expected = expected.filter(function(at:Number, index:int, list:Array):Boolean
                {
                    _isUnclear ||= Math.abs(at - most) < slack || Math.abs(at) < slack && at != 0;
                    return at >= 0 && at <= most;
                });
            if (found.length > 0 && found[0] == 0 && (expected.length == 0 || expected[0] > 0))
            {
                // it begins inside
                found.shift();
            }
            counts.all += expected.length > 0 ? 1 : 0;
            if (_isUnclear)
            {
                counts.unclear += expected.length > 0 ? 1 : 0;
                return;
            }
            counts.agents += expected.length > 0 ? 1 : 0;
            message += ", a " + agent.shape + " of size " + agent.size + " at " + agent.x + ", " + agent.y + ", " + agent.z + ": " + found + ", not " + expected;
            assertEquals(message, expected.length, found.length);
            for (var i:int = 0; i < found.length; i++)
            {
                assertTrue(message, Math.abs(found[i] - expected[i]) < slack);
            }
        }

        // Of each agent, the first surface is its only hit without the others.
        private function checkFirsts(message:String, hits:Vector.<RayHit>, firsts:Vector.<RayHit>):void
        {
            var met:Vector.<Agent> = new Vector.<Agent>();
            var lasts:Object = {};
            for (var i:int = 0; i < hits.length; i++)
            {
                var hit:RayHit = hits[i];
                assertTrue(message + ": in order", i == 0 || hit.distance > hits[i - 1].distance
                        || hit.distance == hits[i - 1].distance && _agents.indexOf(hit.agent) >= _agents.indexOf(hits[i - 1].agent));
                if (met.indexOf(hit.agent) >= 0)
                {
                    continue;
                }
                assertTrue(message, met.length < firsts.length);
                var first:RayHit = firsts[met.length];
                assertTrue(message + ", a " + hit.agent.shape + ": " + hit.distance + ", not " + first.distance, hit.agent == first.agent && hit.distance == first.distance
                        && hit.triangle == first.triangle && hit.point.equals(first.point));
                assertTrue(message + ": " + hit.normal + ", not " + first.normal, hit.normal.equals(first.normal));
                met.push(hit.agent);
            }
            assertEquals(message, firsts.length, met.length);
        }

        // Every triangle (Möller and Trumbore, 1997). A triangle that is nearly met, or nearly not, is not clear.
        private function trianglesOf(agent:Agent):Array
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            EveryTriangle.place(agent.freshPlacement(), sModels[agent.shape], corners);
            var found:Array = [];
            var sides:Array = [];
            var unit:Vector3D = unitDirection();
            for (var i:int = 0; i < corners.length; i += 9)
            {
                var a:Vector3D = new Vector3D(corners[i], corners[i + 1], corners[i + 2]);
                var u:Vector3D = new Vector3D(corners[i + 3], corners[i + 4], corners[i + 5]).subtract(a);
                var v:Vector3D = new Vector3D(corners[i + 6], corners[i + 7], corners[i + 8]).subtract(a);
                var across:Vector3D = unit.crossProduct(v);
                var volume:Number = u.dotProduct(across);
                var from:Vector3D = _origin.subtract(a);
                var shareU:Number = from.dotProduct(across) / volume;
                var aside:Vector3D = from.crossProduct(u);
                var shareV:Number = unit.dotProduct(aside) / volume;
                var inside:Number = Math.min(shareU, shareV, 1 - shareU - shareV);
                var far:Number = 1e-9 * (1 + from.length / agent.size);
                if (!(Math.abs(inside) > far) || !(Math.abs(volume) > 1e-6 * u.length * v.length))
                {
                    _isUnclear ||= from.crossProduct(unit).lengthSquared < 4 * (u.lengthSquared + v.lengthSquared);
                }
                else if (inside > 0)
                {
                    add(v.dotProduct(aside) / volume, volume > 0, found, sides, agent.size);
                }
            }
            return found;
        }

        // Triangles at one place, from the same side, are one.
        private function add(at:Number, side:Boolean, found:Array, sides:Array, size:Number):void
        {
            for (var i:int = 0; i < found.length; i++)
            {
                if (Math.abs(found[i] - at) < 1e-9 * (size + Math.abs(at)))
                {
                    if (sides[i] == side)
                    {
                        return;
                    }
                }
            }
            found.push(at);
            sides.push(side);
        }

        // Where the ray enters and leaves the nodes of a depth, each found by itself.
        private function nodesOf(agent:Agent):Array
        {
            var parts:Array = [];
            addNodes(sGreatLand.hierarchies.root(agent.shape), 5, agent, parts);
            parts.sort(function(a:Array, b:Array):int
                {
                    return a[0] < b[0] ? -1 : (a[0] > b[0] ? 1 : 0);
                });
            var found:Array = [];
            var near:Number = 1e-10 * agent.size + 1e-14 * (Math.abs(agent.x) + Math.abs(agent.y) + _origin.length);
            var end:Number = -Infinity;
            for each (var part:Array in parts)
            {
                if (part[0] > end + near || end == -Infinity)
                {
                    found.push(Math.max(0, part[0]));
                    if (end > -Infinity)
                    {
                        found.push(end);
                    }
                    end = part[1];
                }
                end = Math.max(end, part[1]);
            }
            if (end > -Infinity)
            {
                found.push(end);
            }
            return found;
        }

        private function addNodes(node:HierarchyNode, levels:int, agent:Agent, parts:Array):void
        {
            if (!node.isLeaf && levels > 1)
            {
                addNodes(node.left, levels - 1, agent, parts);
                addNodes(node.right, levels - 1, agent, parts);
                return;
            }
            var at:Placement = agent.freshPlacement();
            var box:Box = Box(node.bounds);
            var unit:Vector3D = unitDirection();
            var from:Vector3D = _origin.subtract(new Vector3D(at.x, at.y, at.z));
            var enter:Number = 0;
            var leave:Number = Infinity;
            // of a flat node
            var plane:Number = NaN;
            var axes:Array = [new Vector3D(at.r00, at.r10, at.r20), new Vector3D(at.r01, at.r11, at.r21), new Vector3D(at.r02, at.r12, at.r22)];
            var middles:Array = [box.center.x, box.center.y, box.center.z];
            var halves:Array = [box.halfX, box.halfY, box.halfZ];
            var near:Number = 1e-10 * (agent.size + from.length) + 1e-14 * (Math.abs(agent.x) + Math.abs(agent.y) + _origin.length);
            for (var axis:int = 0; axis < 3; axis++)
            {
                var offset:Number = from.dotProduct(axes[axis]) - at.size * middles[axis];
                var speed:Number = unit.dotProduct(axes[axis]);
                var half:Number = at.size * halves[axis];
                if (Math.abs(speed) < 1e-9)
                {
                    _isUnclear ||= Math.abs(Math.abs(offset) - half) < 1e-8 * from.length + near;
                    leave = Math.abs(offset) > half ? -1 : leave;
                    continue;
                }
                if (half == 0)
                {
                    plane = -offset / speed;
                    continue;
                }
                enter = Math.max(enter, (-half * (speed > 0 ? 1 : -1) - offset) / speed);
                leave = Math.min(leave, (half * (speed > 0 ? 1 : -1) - offset) / speed);
            }
            if (!isNaN(plane))
            {
                _isUnclear ||= Math.abs(plane - enter) < near || Math.abs(plane - leave) < near;
                leave = plane >= enter && plane <= leave ? plane : -1;
                enter = leave < 0 ? enter : plane;
            }
            else
            {
                _isUnclear ||= Math.abs(leave - enter) < near;
            }
            if (enter <= leave)
            {
                parts.push([enter, leave]);
            }
        }

        private function ofSphere(middle:Vector3D, radius:Number):Array
        {
            var unit:Vector3D = unitDirection();
            var to:Vector3D = middle.subtract(_origin);
            var along:Number = to.dotProduct(unit);
            var foot:Vector3D = unit.clone();
            foot.scaleBy(along);
            var aside:Number = to.subtract(foot).length;
            _isUnclear ||= Math.abs(aside - radius) < 1e-4 * radius + 1e-9 * to.length;
            if (aside > radius)
            {
                return [];
            }
            var half:Number = Math.sqrt(radius * radius - aside * aside);
            return along + half < 0 ? [] : [Math.max(0, along - half), along + half];
        }

        [Test]
        public function anEdgeIsOneSurface():void
        {
            assertEquals("a diagonal", "5", distances("sheet", 0.25, 0.25, 5, 0, 0, -1));
            assertEquals("a diagonal, slanting", 1, castOf("sheet", 0.25 - 1, 0.25 + 2, 5, 1, -2, -5).length);
            assertEquals("a corner", "5", distances("sheet", 0.5, 0.5, 5, 0, 0, -1));
            assertEquals("in the plane", 1, castOf("sheet", -5, 0.1, 0, 1, 0, 0).length);
            assertEquals("along the diagonal", 1, castOf("sheet", -5, -5, 0, 1, 1, 0).length);
            assertEquals("through a cube's faces at their diagonals", "4,5", distances("cube", 0.25, 0.25, 5, 0, 0, -1));
            assertEquals("through a cube's edges", 2, castOf("cube", -5, 0.1, -4.5, 1, 0, 1).length);
            assertEquals("through a cube's corners", 2, castOf("cube", -5, -5, -4.5, 1, 1, 1).length);
            assertEquals("along a cube's face", "4.5,5.5", distances("cube", -5, 0.1, 1, 1, 0, 0));
            assertEquals("along a cube's edge", "4.5,5.5", distances("cube", -5, 0.5, 1, 1, 0, 0));
            var grazing:Vector.<RayHit> = castOf("cube", -5, 0.1, -3.5, 1, 0, 1);
            assertEquals("past a cube's edge: in and out", 2, grazing.length);
            assertTrue(Math.abs(grazing[0].distance - grazing[1].distance) < 1e-12);
        }

        [Test]
        public function whatIsBehindASheetInTheRayCounts():void
        {
            // two sheets in a row, and a wall across
            addModel(new Model("row", new <Number>[-0.5, -0.2, 0, -0.1, -0.2, 0, -0.1, 0.2, 0, -0.5, 0.2, 0, 0, -0.2, 0, 0.25, -0.2, 0, 0.25, 0.2, 0, 0, 0.2, 0,
                            0.5, -0.2, -0.2, 0.5, 0.2, -0.2, 0.5, 0.2, 0.2, 0.5, -0.2, 0.2],
                        new <uint>[0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7, 8, 9, 10, 8, 10, 11], Model.AS_GIVEN));
            assertEquals("4.5,5,5.5", distances("row", -5, 0.125, 0, 1, 0, 0));
            assertEquals("from the other side", "4.5,4.75,5.1", distances("row", 5, 0.125, 0, -1, 0, 0));
        }

        [Test]
        public function everySurfaceCounts():void
        {
            addModel(SolidModels.of("tower", [[1, 0, 0, 0, false], [1, 0, 0, 1, false]], Model.AS_GIVEN));
            var hits:Vector.<RayHit> = castOf("tower", 0.1, 0.2, 5, 0, 0, -1);
            assertEquals("two faces at one place", 4, hits.length);
            assertEquals(hits[1].distance, hits[2].distance);
            assertEquals("from inside", "0,0.5", distances("cube", 0.1, 0.2, 0.5, 0, 0, -1));
            assertEquals("no farther", "0", distances("cube", 0.1, 0.2, 0.5, 0, 0, -1, 0.49));
            assertEquals("just as far", "0,0.5", distances("cube", 0.1, 0.2, 0.5, 0, 0, -1, 0.5));
            assertEquals("a sphere of the bins", "4,5", distances("cube", 0, 0, 5, 0, 0, -1, Infinity, "bins"));
            assertEquals("its leaving within rounding", "4,5", distances("cube", 0, 0, 5, 0, 0, -1, 5.000001, "bins"));
            assertEquals("not so far", "4", distances("cube", 0, 0, 5, 0, 0, -1, 4.5, "bins"));
            assertEquals("from inside", "0,0.5", distances("cube", 0, 0, 0.5, 0, 0, -1, Infinity, "bins"));
            assertEquals("a box", "4,5", distances("cube", 0.1, 0.2, 5, 0, 0, -1, Infinity, "tightest fits"));
            hits = castOf("cube", 0.1, 0.2, 5, 0, 0, -1, Infinity, "tightest fits");
            assertTrue("against the ray", hits[0].normal.equals(new Vector3D(0, 0, 1)) && hits[1].normal.equals(new Vector3D(0, 0, 1)));
            assertTrue(Vector3D.distance(hits[1].point, new Vector3D(0.1, 0.2, 0)) < 1e-9);
            hits = castOf("cube", 0.1, 0.2, 5, 0, 0, -1);
            assertTrue("triangles", hits[0].triangle >= 0 && hits[1].triangle >= 0 && hits[0].triangle != hits[1].triangle);
        }

        [Test]
        public function aFilterIsAskedOnceForAnAgent():void
        {
            _agents = new <Agent>[new Agent("cube"), new Agent("cube"), new Agent("cube")];
            _agents[1].moveTo(3, 0, 0);
            _agents[2].moveTo(6, 0, 0);
            var asked:Array = [];
            var filter:AgentFilter = new AgentFilter();
            filter.accepts = function(agent:Agent):Boolean
            {
                asked.push(_agents.indexOf(agent));
                return agent != _agents[1];
            };
            var out:Vector.<RayHit> = new <RayHit>[new RayHit(), null];
            var kept:RayHit = out[0];
            var queries:AgentQueries = queriesOf("triangles");
            assertTrue(out === queries.castAll(new Vector3D(-5, 0.1, 0.2), new Vector3D(2, 0, 0), Infinity, filter, out, true));
            assertEquals("0,1,2", asked.join());
            assertEquals("4.5,5.5,10.5,11.5", textOf(out));
            assertTrue(kept === out[0]);
            assertEquals("without", "4.5,10.5", textOf(queries.castAll(new Vector3D(-5, 0.1, 0.2), new Vector3D(2, 0, 0), Infinity, filter, out)));
        }

        [Test]
        public function theGroundIsCrossedOnBothSidesOfAHill():void
        {
            var collision:Collision = new Collision(EachCollider.make("triangles", sGreatLand));
            collision.terrain = new Terrain(21, 21, 1, -10, -10);
            collision.terrain.setHeight(10, 10, 4);
            var queries:AgentQueries = new AgentQueries(collision);
            queries.update(new Vector.<Agent>());
            assertEquals("9.75,10.25", textOf(queries.castAll(new Vector3D(-10, 0, 3), new Vector3D(1, 0, 0), Infinity, null, null, true)));
            assertEquals("along a common edge of triangles", "9.5,10.5", textOf(queries.castAll(new Vector3D(-10, 0, 2), new Vector3D(1, 0, 0), Infinity, null, null, true)));
            assertEquals("from below", "0,2", textOf(queries.castAll(new Vector3D(-3.5, 0.3, -2), new Vector3D(0, 0, 1), Infinity, null, null, true)));
            collision.terrain.isBlocky = true;
            queries.update(new Vector.<Agent>());
            assertEquals("9.5,10.5", textOf(queries.castAll(new Vector3D(-10, 0.1, 3), new Vector3D(1, 0, 0), Infinity, null, null, true)));
        }

        [Test]
        public function underTheGroundNoWallIsCrossed():void
        {
            var terrain:Terrain = new Terrain(5, 5, 1, 0, 0);
            terrain.isBlocky = true;
            terrain.setHeight(2, 2, 5);
            terrain.setHeight(3, 2, 3);
            var queries:AgentQueries = queriesOver(terrain);
            var half:Number = 0.5 * Math.sqrt(10);
            var found:Vector.<RayHit> = queries.castAll(new Vector3D(2, 2.1, 4), new Vector3D(1, 0, -3), Infinity, null, null, true);
            assertEquals("0," + Math.round(5 * half * 1e9) / 1e9, textOf(found));
        }

        /** Where a ray enters and leaves columns, a loop finds between all planes of the columns' sides and tops. */
        [Test]
        public function columnsAreCrossedAsALoopFinds():void
        {
            var terrain:Terrain = new Terrain(6, 6, 1, 0, 0);
            terrain.isBlocky = true;
            var met:int = 0;
            for (var i:int = 0; i < Effort.choose(400, 20000); i++)
            {
                terrain.setHeight(_random.integer(0, 5), _random.integer(0, 5), _random.pick([0, 1, 5, 40, _random.between(-3, 8)]));
                terrain.setHole(_random.integer(0, 5), _random.integer(0, 5), _random.chance(0.2));
                _origin = new Vector3D(_random.between(-2, 7), _random.between(-2, 7), _random.between(-6, 10));
                _direction = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1) * _random.pick([0.1, 1, 9]));
                _direction.normalize();
                var expected:Array = columnsAlongRay(terrain);
                if (_isUnclear)
                {
                    continue;
                }
                var hits:Vector.<RayHit> = queriesOver(terrain).castAll(_origin, _direction, 30, null, null, true);
                var message:String = "ray " + i + " from " + _origin + " along " + _direction + ": " + textOf(hits) + ", not " + expected;
                assertEquals(message, expected.length, hits.length);
                for (var k:int = 0; k < hits.length; k++)
                {
                    assertTrue(message, Math.abs(hits[k].distance - expected[k]) < 1e-9);
                }
                met += hits.length;
            }
            assertTrue(met + " surfaces", met > Effort.choose(400, 20000));
        }

        // The distances up to 30 at which the ray enters and leaves the columns of a terrain of 6 by 6 cells. Planes that are met at nearly the same
        // distance are not clear.
        private function columnsAlongRay(terrain:Terrain):Array
        {
            var events:Array = [0, 30];
            for (var side:int = 0; side <= 6; side++)
            {
                events.push((side - 0.5 - _origin.x) / _direction.x, (side - 0.5 - _origin.y) / _direction.y);
            }
            var planes:Object = {};
            for (var cell:int = 0; cell < 36; cell++)
            {
                var height:Number = terrain.heightAt(cell % 6, int(cell / 6));
                if (isFinite(height) && !planes[height])
                {
                    planes[height] = true;
                    events.push((height - _origin.z) / _direction.z);
                }
            }
            events = events.filter(function(at:Number, index:int, list:Array):Boolean
                {
                    return at >= 0 && at <= 30;
                }).sort(Array.NUMERIC);
            _isUnclear = false;
            var found:Array = [];
            var wasInside:Boolean = false;
            for (var i:int = 1; i < events.length; i++)
            {
                _isUnclear ||= events[i] - events[i - 1] < 1e-6;
                var middle:Number = (events[i] + events[i - 1]) / 2;
                var isInside:Boolean = terrain.heightAt(_origin.x + middle * _direction.x, _origin.y + middle * _direction.y) >= _origin.z + middle * _direction.z;
                if (isInside != wasInside)
                {
                    found.push(events[i - 1]);
                }
                wasInside = isInside;
            }
            return found;
        }

        private static function queriesOver(terrain:Terrain):AgentQueries
        {
            var collision:Collision = new Collision(EachCollider.make("triangles", sGreatLand));
            collision.terrain = terrain;
            var queries:AgentQueries = new AgentQueries(collision);
            queries.update(new Vector.<Agent>());
            return queries;
        }

        /** A ray in the plane of the walls at the border falls on the edge that they share with the slopes. */
        [Test]
        public function atItsBorderTheGroundsFirstSurfaceIsItsHit():void
        {
            var terrain:Terrain = new Terrain(5, 5, 1, 0, 0);
            var queries:AgentQueries = queriesOver(terrain);
            var hits:int = 0;
            for (var i:int = 0; i < 300; i++)
            {
                terrain.setHeight(i % 5, _random.integer(0, 4), _random.between(-1, 1));
                queries.update(new Vector.<Agent>());
                var from:Vector3D = new Vector3D(_random.pick([0, 4]), _random.between(-1, 5), _random.between(1.1, 3));
                var way:Vector3D = new Vector3D(0, _random.between(0, 4) - from.y, -from.z);
                var hit:RayHit = queries.cast(from, way);
                var all:Vector.<RayHit> = queries.castAll(from, way, Infinity, null, null, true);
                if (hit == null)
                {
                    assertEquals(0, all.length);
                    continue;
                }
                hits++;
                assertEquals("ray " + i, hit.distance, all[0].distance);
                assertTrue("ray " + i + ": " + all[0].normal + ", not " + hit.normal, all[0].normal.equals(hit.normal));
            }
            assertTrue(hits + " hits", hits > 200);
        }

        private function castOf(shape:String, x:Number, y:Number, z:Number, dx:Number, dy:Number, dz:Number, most:Number = Infinity, system:String = "triangles"):Vector.<RayHit>
        {
            _agents = new <Agent>[new Agent(shape)];
            return queriesOf(system).castAll(new Vector3D(x, y, z), new Vector3D(dx, dy, dz), most, null, null, true);
        }

        private function distances(shape:String, x:Number, y:Number, z:Number, dx:Number, dy:Number, dz:Number, most:Number = Infinity, system:String = "triangles"):String
        {
            return textOf(castOf(shape, x, y, z, dx, dy, dz, most, system));
        }

        private static function textOf(hits:Vector.<RayHit>):String
        {
            var found:Array = [];
            for each (var hit:RayHit in hits)
            {
                found.push(Math.round(1e9 * hit.distance) / 1e9);
            }
            return found.join();
        }

        private function makeWorld(kind:String, count:int):void
        {
            _agents = RandomWorlds.make(kind, count, "cube", _random);
            for each (var agent:Agent in _agents)
            {
                agent.shape = _random.pick(sShapes);
                agent.heading = _random.pick([0, 90, _random.between(-180, 180)]);
                agent.hierarchical = _random.chance(0.5);
                if (_random.chance(0.5))
                {
                    agent.pitch = _random.between(-90, 90);
                    agent.roll = _random.between(-90, 90);
                }
            }
        }

        private function queriesOf(system:String):AgentQueries
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make(system, sGreatLand));
            queries.update(_agents);
            return queries;
        }

        // From near, far or inside of an agent, towards another, towards one of its vertices, or along an axis.
        private function choose():void
        {
            var agent:Agent = _agents[_random.integer(0, _agents.length - 1)];
            var other:Agent = _agents[_random.integer(0, _agents.length - 1)];
            _origin = _structures.position(agent.size * _random.pick([0.4, 0.4, 3, 100]));
            _origin.incrementBy(new Vector3D(agent.x, agent.y, agent.z + 0.5 * agent.size));
            _direction = _structures.position(0.4 * other.size);
            _direction.incrementBy(new Vector3D(other.x, other.y, other.z + 0.5 * other.size));
            if (_random.chance(0.1))
            {
                var vertices:Vector.<Number> = sModels[other.shape].vertices;
                var at:int = 3 * _random.integer(0, vertices.length / 3 - 1);
                var point:Sphere = new Sphere(new Vector3D(vertices[at], vertices[at + 1], vertices[at + 2]), 0);
                _direction = Sphere(point.place(other.freshPlacement())).center;
            }
            _direction.decrementBy(_origin);
            if (_random.chance(0.2) || _direction.length == 0)
            {
                _direction = _random.pick([Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS]).clone();
                _direction.scaleBy(_random.pick([-2, 1]));
            }
        }

        private function unitDirection():Vector3D
        {
            var unit:Vector3D = _direction.clone();
            unit.normalize();
            return unit;
        }
    }
}

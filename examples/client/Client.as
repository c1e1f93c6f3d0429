package
{
    import flash.display.Shape;
    import flash.display.Sprite;
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.text.TextField;
    import flash.text.TextFieldAutoSize;
    import flash.text.TextFormat;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ModelEvent;
    import starlogo.models.ModelLoader;

    /**
     * A game on nothing but the engine and Flash's display list, seen from above: bears and people walk about a fort and turn where they bump
     * into something; people throw paint at what is in front of them.
     */
    [SWF(width="800", height="600", frameRate="30", backgroundColor="#dfe8cf")]
    public class Client extends Sprite
    {
        private static const PIXELS_A_PATCH:Number = 8;
        private static const HALF_WIDTH:Number = 50;
        private static const HALF_HEIGHT:Number = 37.5;
        private static const FRAMES_A_REPORT:int = 60;
        private static const RANGE:Number = 30;
        private static const PAINTS:Array = [0xd94f3d, 0x3d7bd9, 0xe0a526, 0x8a4fc9];

        private var _greatLand:GreatLand = new GreatLand();
        private var _collision:Collision = new Collision(new CombinationCollider(_greatLand));
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _people:Vector.<Agent> = new Vector.<Agent>();
        private var _balls:Vector.<Agent> = new Vector.<Agent>();
        private var _pictures:Pictures = new Pictures(PIXELS_A_PATCH);
        private var _world:Sprite = new Sprite();
        private var _score:TextField = new TextField();
        private var _frame:int = 0;
        private var _bumps:int = 0;
        private var _hits:int = 0;

        public function Client()
        {
            _world.x = HALF_WIDTH * PIXELS_A_PATCH;
            _world.y = HALF_HEIGHT * PIXELS_A_PATCH;
            addChild(_world);
            _score.defaultTextFormat = new TextFormat("_sans", 14, 0x4a5540);
            _score.autoSize = TextFieldAutoSize.LEFT;
            _score.x = 12;
            _score.y = 572;
            addChild(_score);
            loadModels();
        }

        private function loadModels():void
        {
            var assets:String = loaderInfo.parameters.assets || "../../assets";
            var loader:ModelLoader = new ModelLoader(_greatLand);
            loader.addEventListener(ModelEvent.LOADED, onLoaded);
            loader.addEventListener(ErrorEvent.ERROR, onError);
            loader.addEventListener(Event.COMPLETE, onComplete);
            loader.load("fortress", assets + "/fortress.obj");
            loader.load("tree", assets + "/tree.obj");
            loader.load("bear", assets + "/bear.obj");
            loader.load("person", assets + "/person.dae");
        }

        private function onLoaded(event:ModelEvent):void
        {
            _pictures.addModel(event.model);
        }

        private function onError(event:ErrorEvent):void
        {
            trace("error: " + event.text);
        }

        private function onComplete(event:Event):void
        {
            _greatLand.addModel(BuiltInModel.sphere());
            _pictures.addModel(BuiltInModel.sphere());
            populate();
            _collision.onCollision("bears", Collision.ANY_BREED, turnAway);
            _collision.onCollision("people", Collision.ANY_BREED, turnAway);
            _collision.onCollisionStart("bears", Collision.ANY_BREED, countBump);
            _collision.onCollision("paint", "bears", splash);
            _collision.onCollision("paint", "trees", splash);
            _collision.onCollision("paint", "forts", stopPaint);
            addEventListener(Event.ENTER_FRAME, onFrame);
        }

        private function populate():void
        {
            var fort:Agent = add("fortress", "forts", 0, 0, 24, 0, 0xb9a78c);
            fort.hierarchical = true; // its parts collide; everybody else is the tightest structure around them
            for each (var place:Array in [[-40, 27], [-22, -28], [8, 29], [38, 24], [41, -25], [-43, -6]])
            {
                add("tree", "trees", place[0], place[1], 9, 0, 0x5f8f4e);
            }
            for (var i:int = 0; i < 8; i++)
            {
                add("bear", "bears", -36 + 24 * (i % 4), i < 4 ? 19 : -19, 6, 50 * i, 0x8a6a4a);
            }
            for (i = 0; i < PAINTS.length; i++)
            {
                _people.push(add("person", "people", -30 + 20 * i, i % 2 == 0 ? 30 : -31, 7, 90 * i, PAINTS[i]));
                _balls.push(add("sphere", "paint", 0, 0, 1.4, 0, PAINTS[i]));
                _balls[i].sweeps = true; // it is fast: it meets whatever is on its way
                takeBack(_balls[i]);
            }
        }

        private function add(shape:String, breed:String, x:Number, y:Number, size:Number, heading:Number, color:uint):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.size = size;
            agent.heading = heading;
            agent.color = color;
            agent.jumpTo(x, y, 0);
            _agents.push(agent);
            _world.addChild(_pictures.pictureOf(agent));
            return agent;
        }

        private function onFrame(event:Event):void
        {
            _frame++;
            for each (var agent:Agent in _agents)
            {
                if (agent.breed == "bears" || agent.breed == "people")
                {
                    walk(agent, agent.breed == "bears" ? 0.25 : 0.18);
                }
            }
            for (var i:int = 0; i < _balls.length; i++)
            {
                fly(_balls[i], _people[i]);
            }
            _collision.update(_agents);
            for each (agent in _agents)
            {
                _pictures.update(agent);
            }
            report();
        }

        private function walk(agent:Agent, distance:Number):void
        {
            var angle:Number = agent.heading * Math.PI / 180;
            agent.moveTo(agent.x + distance * Math.cos(angle), agent.y + distance * Math.sin(angle), agent.z);
            if (Math.abs(agent.x) > HALF_WIDTH - 4 || Math.abs(agent.y) > HALF_HEIGHT - 4)
            {
                agent.heading = Math.atan2(-agent.y, -agent.x) * 180 / Math.PI; // back to the middle
            }
        }

        private function fly(ball:Agent, owner:Agent):void
        {
            if (isAway(ball))
            {
                walk(ball, 1.6);
                if (Math.abs(ball.x - owner.x) > RANGE || Math.abs(ball.y - owner.y) > RANGE)
                {
                    takeBack(ball);
                }
            }
            else if ((_frame + 17 * owner.id) % 60 == 0)
            {
                ball.heading = owner.heading;
                ball.jumpTo(owner.x, owner.y, 3);
            }
        }

        private function isAway(ball:Agent):Boolean
        {
            return ball.z > 0;
        }

        // beneath the ground, where it meets nobody and is not drawn
        private function takeBack(ball:Agent):void
        {
            ball.jumpTo(0, 0, -100);
        }

        // out of what was bumped into, and on as a ball from a cushion
        private function turnAway(walker:Agent, other:Agent, contact:Contact):void
        {
            if (other.breed == "paint")
            {
                return;
            }
            var x:Number = contact.normal.x;
            var y:Number = contact.normal.y;
            var angle:Number = walker.heading * Math.PI / 180;
            var towards:Number = x * Math.cos(angle) + y * Math.sin(angle);
            walker.moveTo(walker.x + x * contact.depth, walker.y + y * contact.depth, 0);
            if (towards < 0)
            {
                walker.heading = Math.atan2(Math.sin(angle) - 2 * towards * y, Math.cos(angle) - 2 * towards * x) * 180 / Math.PI;
            }
        }

        private function countBump(bear:Agent, other:Agent):void
        {
            if (other.breed != "paint")
            {
                _bumps++;
            }
        }

        private function splash(ball:Agent, target:Agent, contact:Contact):void
        {
            _hits++;
            target.color = ball.color;
            var drop:Shape = new Shape();
            drop.graphics.beginFill(ball.color, 0.35);
            drop.graphics.drawCircle(PIXELS_A_PATCH * contact.point.x, -PIXELS_A_PATCH * contact.point.y, 7);
            _world.addChildAt(drop, 0);
            takeBack(ball);
        }

        private function stopPaint(ball:Agent, fort:Agent):void
        {
            takeBack(ball);
        }

        private function report():void
        {
            _score.text = "frame " + _frame + ", " + _bumps + " bumps, " + _hits + " hits, "
                + _collision.statistics.candidatePairs + " pairs looked at";
            if (_frame % FRAMES_A_REPORT == 0)
            {
                trace("frame " + _frame + ": " + _bumps + " bumps, " + _hits + " hits");
            }
        }
    }
}

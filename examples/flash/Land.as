package
{
    import flash.display.Graphics;
    import flash.display.Sprite;
    import flash.events.Event;
    import flash.external.ExternalInterface;
    import flash.text.TextField;
    import flash.text.TextFormat;
    import starlogo.agents.Agent;

    /** Draws an example: 24 by 16 patches of land, seen from above. It also moves agents and follows the mouse. It finds no collisions. */
    public class Land extends Sprite
    {
        public static const RED:uint = 0xe4572e;
        public static const ORANGE:uint = 0xf3a712;
        public static const GREEN:uint = 0x4caf6e;
        public static const BLUE:uint = 0x3f88c5;
        public static const PURPLE:uint = 0x8f5fbf;
        public static const GREY:uint = 0xa3adb8;
        public static const COLOURS:Vector.<uint> = new <uint>[RED, ORANGE, GREEN, BLUE, PURPLE];

        /** The length of a patch in drawings. Flash rounds what is drawn to twentieths. */
        protected static const PATCH:Number = 100;

        private static const PIXELS:Number = 25; // a patch, on a stage of 600 by 400
        private static const RIGHT:Number = 12;
        private static const TOP:Number = 8;

        /** The number of this frame, from 1. */
        protected var frame:int = 0;

        /** The place of the mouse, in patches. While the mouse is elsewhere, this place moves by itself. */
        protected var pointerX:Number = 0;
        protected var pointerY:Number = 0;

        /** Holds what is drawn, y up. */
        protected var world:Sprite = new Sprite();

        private var _words:TextField = new TextField();
        private var _seed:Number = 7;

        public function Land()
        {
            world.x = RIGHT * PIXELS;
            world.y = TOP * PIXELS;
            world.scaleX = PIXELS / PATCH;
            world.scaleY = -PIXELS / PATCH;
            addChild(world);
            _words.defaultTextFormat = new TextFormat("_sans", 16, 0x1d2530, true);
            _words.width = 600;
            _words.x = 8;
            _words.y = 370;
            addChild(_words);
            addEventListener(Event.ENTER_FRAME, begin);
        }

        /** A frame of the game: move, collide, draw. */
        protected function step():void
        {
        }

        /** Says something at the lower edge, and to the page. */
        protected function say(text:String):void
        {
            _words.text = text;
        }

        /** A random number between two. Each run gets the same numbers. */
        protected function random(from:Number, to:Number):Number
        {
            _seed = _seed * 16807 % 2147483647;
            return from + (to - from) * _seed / 2147483647;
        }

        /** Makes an agent at a random place. */
        protected function make(shape:String, breed:String, size:Number, color:uint):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.size = size;
            agent.color = color;
            agent.heading = random(0, 360);
            agent.jumpTo(random(-RIGHT, RIGHT) * 0.92, random(-TOP, TOP) * 0.9, 0);
            return agent;
        }

        /** Moves an agent along its heading. It turns back at the edges. */
        protected function walk(agent:Agent, distance:Number):void
        {
            var angle:Number = agent.heading * Math.PI / 180;
            var dx:Number = Math.cos(angle);
            var dy:Number = Math.sin(angle);
            if (Math.abs(agent.x) > RIGHT - agent.size / 2)
            {
                dx = agent.x > 0 ? -Math.abs(dx) : Math.abs(dx);
            }
            if (Math.abs(agent.y) > TOP - agent.size / 2)
            {
                dy = agent.y > 0 ? -Math.abs(dy) : Math.abs(dy);
            }
            turn(agent, dx, dy);
            agent.moveTo(agent.x + distance * dx, agent.y + distance * dy, agent.z);
        }

        /** Turns an agent to a direction. */
        protected function turn(agent:Agent, dx:Number, dy:Number):void
        {
            agent.heading = Math.atan2(dy, dx) * 180 / Math.PI;
        }

        /** Moves an agent towards the pointer, by at most a distance. */
        protected function follow(agent:Agent, distance:Number):void
        {
            var dx:Number = pointerX - agent.x;
            var dy:Number = pointerY - agent.y;
            var way:Number = Math.sqrt(dx * dx + dy * dy);
            var part:Number = way > distance ? distance / way : 1;
            agent.moveTo(agent.x + dx * part, agent.y + dy * part, agent.z);
            if (way > 0.01)
            {
                turn(agent, dx, dy);
            }
        }

        /** Draws agents: cubes as squares, all others as balls. */
        protected function draw(agents:Vector.<Agent>):void
        {
            var pen:Graphics = world.graphics;
            pen.lineStyle(6, 0, 0.3);
            for each (var agent:Agent in agents)
            {
                var x:Number = agent.x * PATCH;
                var y:Number = agent.y * PATCH;
                var size:Number = agent.size * PATCH;
                pen.beginFill(agent.color);
                if (agent.shape == "cube")
                {
                    pen.drawRect(x - size / 2, y - size / 2, size, size);
                }
                else
                {
                    pen.drawCircle(x, y, size / 2);
                }
                pen.endFill();
            }
        }

        /** Draws a line between two agents, and a ring around the second. */
        protected function drawLink(from:Agent, to:Agent, color:uint):void
        {
            world.graphics.lineStyle(12, color);
            world.graphics.moveTo(from.x * PATCH, from.y * PATCH);
            world.graphics.lineTo(to.x * PATCH, to.y * PATCH);
            world.graphics.drawCircle(to.x * PATCH, to.y * PATCH, (to.size / 2 + 0.2) * PATCH);
        }

        /** Draws the slice of a circle in front of an agent. */
        protected function drawSlice(agent:Agent, radius:Number, degrees:Number, color:uint):void
        {
            world.graphics.lineStyle();
            world.graphics.beginFill(color, 0.25);
            world.graphics.moveTo(agent.x * PATCH, agent.y * PATCH);
            for (var i:int = -12; i <= 12; i++)
            {
                var angle:Number = (agent.heading + i * degrees / 24) * Math.PI / 180;
                world.graphics.lineTo((agent.x + radius * Math.cos(angle)) * PATCH, (agent.y + radius * Math.sin(angle)) * PATCH);
            }
            world.graphics.endFill();
        }

        /** Draws lines as the engine gives them: six numbers each, for two points. */
        protected function drawLines(lines:Vector.<Number>, color:uint):void
        {
            world.graphics.lineStyle(5, color);
            for (var i:int = 0; i < lines.length; i += 6)
            {
                world.graphics.moveTo(lines[i] * PATCH, lines[i + 1] * PATCH);
                world.graphics.lineTo(lines[i + 3] * PATCH, lines[i + 4] * PATCH);
            }
        }

        /** Plays as many frames at once as the page asks for, and then stops. Without a number it plays on. */
        private function begin(event:Event):void
        {
            var wanted:int = int(loaderInfo.parameters["frames"]);
            removeEventListener(Event.ENTER_FRAME, begin);
            for (var i:int = 0; i < wanted; i++)
            {
                play(null);
            }
            if (wanted == 0)
            {
                addEventListener(Event.ENTER_FRAME, play);
            }
        }

        private function play(event:Event):void
        {
            frame++;
            var isGuided:Boolean = mouseX <= 0 || mouseY <= 0 || mouseX >= 600 || mouseY >= 400;
            pointerX = isGuided ? 0.72 * RIGHT * Math.sin(frame / 67) : world.mouseX / PATCH;
            pointerY = isGuided ? 0.66 * TOP * Math.sin(frame / 43 + 0.7) : world.mouseY / PATCH;
            world.graphics.clear();
            step();
            if (ExternalInterface.available)
            {
                ExternalInterface.call("said", _words.text, frame);
            }
        }
    }
}
